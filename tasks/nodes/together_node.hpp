#pragma once

#include <vector>

#include "striate/tasks/nodes/task_node.hpp"

namespace striate::tasks {

/// `together`: all children at the same time, each with motors of its own. Succeeds when all have
/// succeeded; when one fails the others are halted, then it fails.
class TogetherNode final : public TaskNode {
 public:
  explicit TogetherNode(std::vector<NodePtr> children);

 protected:
  void on_start(TaskCycle& cycle) override;
  NodeStatus on_tick(TaskCycle& cycle) override;
  bool on_halt(TaskCycle& cycle) override;

 private:
  std::vector<NodePtr> children_;
  std::vector<char> ended_;
  bool all_skipped_ = true;
  bool failing_ = false;
};

}  // namespace striate::tasks
