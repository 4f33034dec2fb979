#pragma once

#include <string>

#include "tasks/sequence.hpp"

namespace striate {

/// How a mission stands.
enum class MissionState { running, succeeded, failed, interrupted };

/// Runs a task: its steps, and after every ending, also after an interruption, its `finally`.
/// One wish a cycle; one motor owner at any time.
class Executive {
 public:
  explicit Executive(Task task);
  Executive(const Executive&) = delete;
  Executive& operator=(const Executive&) = delete;

  /// One cycle. The wish is stop once the mission has ended.
  Wish tick(const ShortTermMemory& memory, TimePoint now);

  /// Ends the mission from outside (Ctrl-C, end of the course): halts the action, then `finally`.
  void interrupt(MissionState as, std::string reason);

  [[nodiscard]] bool ended() const { return phase_ == Phase::ended; }
  /// How the steps ended; final once `ended()`.
  [[nodiscard]] MissionState state() const { return state_; }
  [[nodiscard]] const std::string& reason() const { return reason_; }
  [[nodiscard]] std::string current_action() const;
  [[nodiscard]] const Task& task() const { return task_; }

 private:
  enum class Phase { doing, halting, finally, ended };

  void begin_finally(MissionState state, TimePoint now);
  void tick_finally(const ShortTermMemory& memory, TimePoint now, Wish& wish);

  Task task_;
  Sequence steps_;
  Sequence finally_;
  Phase phase_ = Phase::doing;
  MissionState state_ = MissionState::running;
  MissionState interrupted_as_ = MissionState::running;
  TimePoint finally_since_;
  std::string reason_;
};

}  // namespace striate
