#include "striate/tasks/nodes/together_node.hpp"

#include <algorithm>

namespace striate::tasks {

TogetherNode::TogetherNode(std::vector<NodePtr> children)
    : children_(std::move(children)), ended_(children_.size(), 0) {}

void TogetherNode::on_start(TaskCycle& /*cycle*/) {
  std::fill(ended_.begin(), ended_.end(), 0);
  all_skipped_ = true;
  failing_ = false;
}

NodeStatus TogetherNode::on_tick(TaskCycle& cycle) {
  for (std::size_t i = 0; i < children_.size() && !failing_; ++i) {
    if (ended_[i] != 0) continue;
    const NodeStatus outcome = children_[i]->tick(cycle);
    ended_[i] = outcome == NodeStatus::running ? 0 : 1;
    failing_ = outcome == NodeStatus::failed;
    all_skipped_ = all_skipped_ && outcome == NodeStatus::skipped;
  }
  if (failing_) return on_halt(cycle) ? NodeStatus::failed : NodeStatus::running;
  const bool all_ended = std::count(ended_.begin(), ended_.end(), 0) == 0;
  if (!all_ended) return NodeStatus::running;
  return all_skipped_ ? NodeStatus::skipped : NodeStatus::succeeded;
}

bool TogetherNode::on_halt(TaskCycle& cycle) {
  bool all = true;
  for (const NodePtr& child : children_) all = child->halt(cycle) && all;
  return all;
}

}  // namespace striate::tasks
