#pragma once

#include <vector>

#include "striate/tasks/nodes/task_node.hpp"

namespace striate::tasks {

/// `do`: one after the other, with memory: what is done is not done again. The next child starts
/// in the cycle after the end of the one before.
class SequenceNode final : public TaskNode {
 public:
  /// `keep_going`: a failed child does not end it (for `finally` and recoveries).
  explicit SequenceNode(std::vector<NodePtr> children, bool keep_going = false)
      : children_(std::move(children)), keep_going_(keep_going) {}

 protected:
  void on_start(TaskCycle& cycle) override;
  NodeStatus on_tick(TaskCycle& cycle) override;
  bool on_halt(TaskCycle& cycle) override;

 private:
  std::vector<NodePtr> children_;
  bool keep_going_;
  std::size_t index_ = 0;
  bool all_skipped_ = true;
};

}  // namespace striate::tasks
