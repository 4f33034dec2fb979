#pragma once

#include <memory>
#include <optional>
#include <string>

#include "striate/tasks/condition.hpp"
#include "striate/tasks/nodes/task_node.hpp"

namespace striate::tasks {

/// What ends a step from outside.
struct Limits {
  std::unique_ptr<Condition> until;  ///< nullptr: the step ends by itself
  std::optional<Duration> within;    ///< longer than this is a failure
};

/// `until` and `within`: halts its child when the goal is detected (success) or the time is over
/// (failure), over several cycles if the child needs them.
class LimitedNode final : public TaskNode {
 public:
  /// @param label of the step, with its line, for reports.
  LimitedNode(std::string label, int line, NodePtr child, Limits limits)
      : label_(std::move(label)),
        line_(line),
        child_(std::move(child)),
        limits_(std::move(limits)) {}

 protected:
  void on_start(TaskCycle& cycle) override;
  NodeStatus on_tick(TaskCycle& cycle) override;
  bool on_halt(TaskCycle& cycle) override { return child_->halt(cycle); }

 private:
  std::string label_;
  int line_;
  NodePtr child_;
  Limits limits_;
  TimePoint started_;
  NodeStatus pending_ = NodeStatus::running;  ///< what it will have been once the child is halted
};

}  // namespace striate::tasks
