#pragma once

#include "striate/tasks/nodes/task_node.hpp"

namespace striate::tasks {

/// `repeat`: runs its step a given number of times, or until it is halted. A round that fails ends
/// it.
class RepeatNode final : public TaskNode {
 public:
  /// @param times 0: for ever.
  RepeatNode(NodePtr child, int times) : child_(std::move(child)), times_(times) {}

 protected:
  void on_start(TaskCycle& /*cycle*/) override { done_ = 0; }
  NodeStatus on_tick(TaskCycle& cycle) override {
    const NodeStatus outcome = child_->tick(cycle);
    if (outcome == NodeStatus::running || outcome == NodeStatus::failed) return outcome;
    if (times_ == 0) return NodeStatus::running;
    return ++done_ >= times_ ? NodeStatus::succeeded : NodeStatus::running;
  }
  bool on_halt(TaskCycle& cycle) override { return child_->halt(cycle); }

 private:
  NodePtr child_;
  int times_;
  int done_ = 0;
};

}  // namespace striate::tasks
