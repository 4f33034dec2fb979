#include "tasks/nodes/together_node.hpp"

#include <algorithm>

namespace striate {

TogetherNode::TogetherNode(std::vector<NodePtr> children)
    : children_(std::move(children)), ended_(children_.size(), 0) {}

void TogetherNode::on_start(TaskCycle& /*cycle*/) {
  std::fill(ended_.begin(), ended_.end(), 0);
  all_skipped_ = true;
  failing_ = false;
}

Outcome TogetherNode::on_tick(TaskCycle& cycle) {
  for (std::size_t i = 0; i < children_.size() && !failing_; ++i) {
    if (ended_[i] != 0) continue;
    const Outcome outcome = children_[i]->tick(cycle);
    ended_[i] = outcome == Outcome::running ? 0 : 1;
    failing_ = outcome == Outcome::failed;
    all_skipped_ = all_skipped_ && outcome == Outcome::skipped;
  }
  if (failing_) return on_halt(cycle) ? Outcome::failed : Outcome::running;
  const bool all_ended = std::count(ended_.begin(), ended_.end(), 0) == 0;
  if (!all_ended) return Outcome::running;
  return all_skipped_ ? Outcome::skipped : Outcome::succeeded;
}

bool TogetherNode::on_halt(TaskCycle& cycle) {
  bool all = true;
  for (const NodePtr& child : children_) all = child->halt(cycle) && all;
  return all;
}

}  // namespace striate
