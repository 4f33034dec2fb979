#pragma once

#include <vector>

#include "striate/tasks/nodes/task_node.hpp"

namespace striate::tasks {

/// `try`: the first child that works. Fails when all have failed.
class TryNode final : public TaskNode {
 public:
  explicit TryNode(std::vector<NodePtr> children) : children_(std::move(children)) {}

 protected:
  void on_start(TaskCycle& cycle) override;
  NodeStatus on_tick(TaskCycle& cycle) override;
  bool on_halt(TaskCycle& cycle) override;

 private:
  std::vector<NodePtr> children_;
  std::size_t index_ = 0;
  bool all_skipped_ = true;
};

}  // namespace striate::tasks
