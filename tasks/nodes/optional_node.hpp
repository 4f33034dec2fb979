#pragma once

#include "tasks/nodes/task_node.hpp"

namespace striate {

/// `optional: true`: a failure counts as a success.
class OptionalNode final : public TaskNode {
 public:
  explicit OptionalNode(NodePtr child) : child_(std::move(child)) {}

 protected:
  Outcome on_tick(TaskCycle& cycle) override {
    const Outcome outcome = child_->tick(cycle);
    return outcome == Outcome::failed ? Outcome::succeeded : outcome;
  }
  bool on_halt(TaskCycle& cycle) override { return child_->halt(cycle); }

 private:
  NodePtr child_;
};

}  // namespace striate
