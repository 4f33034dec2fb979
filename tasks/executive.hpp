#pragma once

#include <string>
#include <string_view>

#include "striate/behaviours/control/arbiter.hpp"
#include "striate/tasks/task.hpp"

namespace striate::tasks {

/// How a mission stands.
enum class MissionState { running, succeeded, failed, interrupted };

/// What a task wants in one cycle.
struct TaskDecision {
  behaviours::Claim claim;  ///< a guard's while it holds the robot still, else a behaviour's
  std::string_view doing;   ///< the action that runs; "" when none does. Lives as the task does.
  bool ended = false;       ///< the mission is over; the wish is to stand
};

/// Runs a task: its tree, and after every ending, also after an interruption, its `finally`.
/// One wish a cycle; one motor owner at any time. Ticking allocates nothing.
class Executive {
 public:
  /// @throws std::logic_error for a task without a tree.
  explicit Executive(Task task);
  Executive(const Executive&) = delete;
  Executive& operator=(const Executive&) = delete;

  /// One cycle.
  TaskDecision tick(const memory::ShortTermMemory& memory, TimePoint now);

  /// Ends the mission from outside (Ctrl-C, end of the course): halts the actions, then `finally`.
  void interrupt(MissionState as, std::string reason);

  [[nodiscard]] bool ended() const { return ended_; }
  /// It was ended from outside.
  [[nodiscard]] bool interrupted() const { return interrupted_; }
  /// How the steps ended; final once `ended()`.
  [[nodiscard]] MissionState state() const { return state_; }
  [[nodiscard]] std::string reason() const;
  /// The newest failure of a step, also of one that was made good.
  [[nodiscard]] const Reason& newest_failure() const { return reason_; }
  /// The action that ran in the last cycle; "" when none did.
  [[nodiscard]] std::string_view current_action() const { return doing_; }
  [[nodiscard]] const Task& task() const { return task_; }

 private:
  void advance(TaskCycle& cycle);

  Task task_;
  MissionState state_ = MissionState::running;
  bool interrupted_ = false;
  MissionState interrupted_as_ = MissionState::running;
  bool ended_ = false;
  long cycles_ = 0;
  std::string interrupted_why_;
  Reason reason_;
  std::string_view doing_;
};

}  // namespace striate::tasks
