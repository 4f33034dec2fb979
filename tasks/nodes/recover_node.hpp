#pragma once

#include "striate/tasks/nodes/task_node.hpp"

namespace striate::tasks {

/// `if_it_fails`: when the child fails, the recovery is run, and then the child again, so many
/// times. However the recovery ends, the child is tried again.
class RecoverNode final : public TaskNode {
 public:
  RecoverNode(NodePtr child, NodePtr recovery, int tries)
      : child_(std::move(child)), recovery_(std::move(recovery)), tries_(tries) {}

 protected:
  void on_start(TaskCycle& /*cycle*/) override {
    used_ = 0;
    recovering_ = false;
  }
  NodeStatus on_tick(TaskCycle& cycle) override {
    if (recovering_) {
      recovering_ = recovery_->tick(cycle) == NodeStatus::running;
      return NodeStatus::running;
    }
    const NodeStatus outcome = child_->tick(cycle);
    if (outcome != NodeStatus::failed || used_ >= tries_) return outcome;
    ++used_;
    recovering_ = true;
    return NodeStatus::running;
  }
  bool on_halt(TaskCycle& cycle) override {
    return (recovering_ ? recovery_ : child_)->halt(cycle);
  }

 private:
  NodePtr child_;
  NodePtr recovery_;
  int tries_;
  int used_ = 0;
  bool recovering_ = false;
};

}  // namespace striate::tasks
