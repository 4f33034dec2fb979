#pragma once

#include <algorithm>
#include <deque>
#include <optional>
#include <utility>

#include "striate/base/time.hpp"

namespace striate::pioneer {

/// Questions under way on a line that loses bytes but keeps their order. When one is answered, all
/// that were asked before it are lost: their answers would have come first. Of several alike the
/// oldest counts as the one that was answered, so that an answer is never taken for younger than it
/// is.
/// @tparam Id tells answers apart as far as the protocol does
template <class Id>
class Questions {
 public:
  void ask(Id id, TimePoint at) {
    if (under_way_.size() == kMost) under_way_.pop_front();
    under_way_.push_back({std::move(id), at});
  }
  /// When the question was asked that this answers; nothing: nobody has asked.
  std::optional<TimePoint> answer(const Id& id) {
    const auto asked = find(id);
    if (asked == under_way_.end()) return std::nullopt;
    const TimePoint at = asked->at;
    under_way_.erase(under_way_.begin(), asked + 1);
    return at;
  }
  [[nodiscard]] bool waits_for(const Id& id) const { return find(id) != under_way_.end(); }
  /// When the oldest that may still be answered was asked; nothing: none is under way.
  [[nodiscard]] std::optional<TimePoint> oldest() const {
    if (under_way_.empty()) return std::nullopt;
    return under_way_.front().at;
  }
  [[nodiscard]] std::optional<TimePoint> newest() const {
    if (under_way_.empty()) return std::nullopt;
    return under_way_.back().at;
  }
  void clear() { under_way_.clear(); }

 private:
  struct Question {
    Id id;
    TimePoint at;
  };
  [[nodiscard]] auto find(const Id& id) const {
    return std::find_if(under_way_.begin(), under_way_.end(),
                        [&](const Question& question) { return question.id == id; });
  }
  /// 15 s of questions to servos, 30 ms apart: no line holds bytes so long
  static constexpr std::size_t kMost = 512;
  std::deque<Question> under_way_;
};

}  // namespace striate::pioneer
