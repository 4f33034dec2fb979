#include "tasks/executive.hpp"

namespace striate {
namespace {

/// A `finally` that does not end must not keep the robot for ever.
constexpr Duration kFinallyLimit = std::chrono::seconds(30);

}  // namespace

Executive::Executive(Task task)
    : task_(std::move(task)), steps_(task_.steps), finally_(task_.finally, true) {}

Wish Executive::tick(const ShortTermMemory& memory, TimePoint now) {
  Wish wish = standing_wish(memory, "");
  if (phase_ == Phase::doing) {
    const Outcome outcome = steps_.tick(memory, now, wish);
    if (outcome != Outcome::running) {
      reason_ = steps_.reason();
      begin_finally(outcome == Outcome::succeeded ? MissionState::succeeded : MissionState::failed,
                    now);
    }
  } else if (phase_ == Phase::halting) {
    if (steps_.halt(memory, wish)) begin_finally(interrupted_as_, now);
  } else if (phase_ == Phase::finally) {
    tick_finally(memory, now, wish);
  }
  return wish;
}

void Executive::begin_finally(MissionState state, TimePoint now) {
  state_ = state;
  finally_since_ = now;
  phase_ = Phase::finally;
}

void Executive::tick_finally(const ShortTermMemory& memory, TimePoint now, Wish& wish) {
  const bool too_long = now - finally_since_ > kFinallyLimit;
  const bool over =
      too_long ? finally_.halt(memory, wish) : finally_.tick(memory, now, wish) != Outcome::running;
  if (over) phase_ = Phase::ended;
}

void Executive::interrupt(MissionState as, std::string reason) {
  if (phase_ != Phase::doing) return;
  interrupted_as_ = as;
  reason_ = std::move(reason);
  phase_ = Phase::halting;
}

std::string Executive::current_action() const {
  switch (phase_) {
    case Phase::doing:
      return steps_.current_action();
    case Phase::halting:
      return "halting";
    case Phase::finally:
      return finally_.current_action();
    case Phase::ended:
      break;
  }
  return "";
}

}  // namespace striate
