#pragma once

#include <memory>

#include "striate/tasks/condition.hpp"
#include "striate/tasks/nodes/task_node.hpp"

namespace striate::tasks {

/// `only_if` and `unless`: looked at once, before the child starts. Where they forbid it the child
/// is skipped: `do` goes on with the next step, `try` with the next alternative.
class OnlyIfNode final : public TaskNode {
 public:
  /// Either condition may be nullptr.
  OnlyIfNode(NodePtr child, std::unique_ptr<Condition> only_if, std::unique_ptr<Condition> unless)
      : child_(std::move(child)), only_if_(std::move(only_if)), unless_(std::move(unless)) {}

 protected:
  void on_start(TaskCycle& cycle) override {
    if (only_if_) only_if_->start(cycle.memory());
    if (unless_) unless_->start(cycle.memory());
    allowed_ = (!only_if_ || only_if_->holds(cycle.memory())) &&
               (!unless_ || !unless_->holds(cycle.memory()));
  }
  NodeStatus on_tick(TaskCycle& cycle) override {
    return allowed_ ? child_->tick(cycle) : NodeStatus::skipped;
  }
  bool on_halt(TaskCycle& cycle) override { return child_->halt(cycle); }

 private:
  NodePtr child_;
  std::unique_ptr<Condition> only_if_;
  std::unique_ptr<Condition> unless_;
  bool allowed_ = false;
};

}  // namespace striate::tasks
