#pragma once

#include "striate/tasks/nodes/task_node.hpp"

namespace striate::tasks {

/// `optional: true`: a failure counts as a success.
class OptionalNode final : public TaskNode {
 public:
  explicit OptionalNode(NodePtr child) : child_(std::move(child)) {}

 protected:
  NodeStatus on_tick(TaskCycle& cycle) override {
    const NodeStatus outcome = child_->tick(cycle);
    return outcome == NodeStatus::failed ? NodeStatus::succeeded : outcome;
  }
  bool on_halt(TaskCycle& cycle) override { return child_->halt(cycle); }

 private:
  NodePtr child_;
};

}  // namespace striate::tasks
