#include "striate/tasks/joined_conditions.hpp"

#include <utility>

namespace striate::tasks {
namespace {

/// Holds while all of them do, or any of them.
template <bool kAll>
class Joined final : public Condition {
 public:
  explicit Joined(Conditions conditions) : conditions_(std::move(conditions)) {}
  void start(const memory::ShortTermMemory& memory) override {
    for (const auto& condition : conditions_) condition->start(memory);
  }
  /// Every one is asked in every cycle, also where the first has decided: some count the cycles in
  /// which they are asked, as `stands_for`.
  [[nodiscard]] bool holds(const memory::ShortTermMemory& memory) const override {
    std::size_t held = 0;
    for (const auto& condition : conditions_) held += condition->holds(memory) ? 1 : 0;
    return kAll ? held == conditions_.size() : held > 0;
  }

 private:
  Conditions conditions_;
};

class Not final : public Condition {
 public:
  explicit Not(std::unique_ptr<Condition> condition) : condition_(std::move(condition)) {}
  void start(const memory::ShortTermMemory& memory) override { condition_->start(memory); }
  [[nodiscard]] bool holds(const memory::ShortTermMemory& memory) const override {
    return !condition_->holds(memory);
  }

 private:
  std::unique_ptr<Condition> condition_;
};

}  // namespace

bool joins_conditions(const std::string& word) {
  return word == "all" || word == "any" || word == "not";
}

std::unique_ptr<Condition> all_of(Conditions conditions) {
  return std::make_unique<Joined<true>>(std::move(conditions));
}

std::unique_ptr<Condition> any_of(Conditions conditions) {
  return std::make_unique<Joined<false>>(std::move(conditions));
}

std::unique_ptr<Condition> not_of(std::unique_ptr<Condition> condition) {
  return std::make_unique<Not>(std::move(condition));
}

}  // namespace striate::tasks
