#pragma once

#include <memory>
#include <string>
#include <vector>

#include "striate/tasks/condition.hpp"
#include "striate/tasks/nodes/task_node.hpp"

namespace striate::tasks {

/// One line of `always`.
struct Guard {
  enum class Kind : std::uint8_t { pause_if, fail_if };
  Kind kind = Kind::pause_if;
  std::string text;  ///< "battery_below: 20 %", for reports
  int line = 0;
  std::unique_ptr<Condition> condition;
};

/// A whole task, or one that another task uses: its guards, its steps, and its `finally`, which is
/// run after every ending: success, failure, and when the task is halted.
class ScopeNode final : public TaskNode {
 public:
  /// A `finally` that does not end must not keep the robot for ever. By hand.
  static constexpr Duration kFinallyLimit = std::chrono::seconds(30);

  /// @param finally nullptr: there is none.
  ScopeNode(std::vector<Guard> guards, NodePtr steps, NodePtr finally)
      : guards_(std::move(guards)), steps_(std::move(steps)), finally_(std::move(finally)) {}

  /// How the steps ended, also while `finally` still runs; running before.
  [[nodiscard]] NodeStatus steps_outcome() const { return outcome_; }

 protected:
  void on_start(TaskCycle& cycle) override;
  NodeStatus on_tick(TaskCycle& cycle) override;
  bool on_halt(TaskCycle& cycle) override;

 private:
  enum class Phase : std::uint8_t { doing, halting, finally };

  /// The first guard that holds, or nullptr: checked every cycle, top first.
  [[nodiscard]] const Guard* holding(TaskCycle& cycle) const;
  NodeStatus tick_steps(TaskCycle& cycle);
  NodeStatus tick_finally(TaskCycle& cycle);
  NodeStatus begin_finally(TaskCycle& cycle, NodeStatus outcome);

  std::vector<Guard> guards_;
  NodePtr steps_;
  NodePtr finally_;
  Phase phase_ = Phase::doing;
  NodeStatus outcome_ = NodeStatus::running;
  TimePoint finally_since_;
  long ticked_in_ = 0;  ///< number of the cycle in which `finally` had its tick
};

}  // namespace striate::tasks
