#pragma once

#include <algorithm>
#include <optional>

#include "striate/base/time.hpp"

namespace striate::pioneer {

/// When something was sent, by our clock, from what the sender's clock showed. Two things bound how
/// the clocks lie to each other: a message that answers a question was sent after the question
/// was, and no message was sent after it arrived. The first finds a delay that was there from the
/// beginning; without any answer the message that was least under way is taken to be fresh.
/// Pure; one line, whose messages keep their order.
class LineClock {
 public:
  /// A message arrived; call it for each. @param sent by the sender's clock
  void heard(Duration sent, TimePoint arrived) {
    if (newest_sent_ && *newest_sent_ - sent > kBack) begin_anew();  // the sender's clock was set
    const Duration drift = least_ ? (arrived - last_) / kDriftShare : Duration{};
    const Duration apart = arrived.time_since_epoch() - sent;
    least_ = least_ ? std::min(*least_ + drift, apart) : apart;
    if (bound_) bound_ = std::min(*bound_ + drift, *least_);
    newest_sent_ = newest_sent_ ? std::max(*newest_sent_, sent) : sent;
    last_ = arrived;
  }
  /// A message was an answer. @param asked by our clock; @param sent by the sender's
  void answered(TimePoint asked, Duration sent) {
    const Duration apart = asked.time_since_epoch() - sent;
    bound_ = bound_ ? std::max(*bound_ - kForget, apart) : apart;
    if (least_) bound_ = std::min(*bound_, *least_);
  }
  /// Not before this, by our clock, was it sent. Call `heard` for it first.
  [[nodiscard]] TimePoint at(Duration sent) const {
    return TimePoint(sent + bound_.value_or(least_.value_or(Duration{})));
  }
  /// Something was answered: what `at` says is a bound and no guess.
  [[nodiscard]] bool is_bounded() const { return bound_.has_value(); }
  /// The line is a new one, or its sender.
  void begin_anew() { *this = LineClock(); }

 private:
  /// A sender's stamps that go back by more: its clock was set, or it was switched off and on
  /// (ours)
  static constexpr Duration kBack = std::chrono::milliseconds(100);
  /// Clocks drift apart by this share of the time that passes: 200 ppm, twice a poor crystal's
  static constexpr int kDriftShare = 5000;
  /// A bound gives way to newer ones: at four answers a second by 4 ms/s, twenty times the drift
  static constexpr Duration kForget = std::chrono::milliseconds(1);
  std::optional<Duration> bound_;  ///< our clock less the sender's is at least so much
  std::optional<Duration> least_;  ///< and at most so much
  std::optional<Duration> newest_sent_;
  TimePoint last_;
};

}  // namespace striate::pioneer
