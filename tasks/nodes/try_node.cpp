#include "striate/tasks/nodes/try_node.hpp"

namespace striate::tasks {

void TryNode::on_start(TaskCycle& /*cycle*/) {
  index_ = 0;
  all_skipped_ = true;
}

NodeStatus TryNode::on_tick(TaskCycle& cycle) {
  for (; index_ < children_.size(); ++index_) {
    const NodeStatus outcome = children_[index_]->tick(cycle);
    if (outcome == NodeStatus::skipped) continue;
    all_skipped_ = false;
    if (outcome != NodeStatus::failed) return outcome;
    // One action a cycle: the next alternative waits for the next cycle.
    if (++index_ < children_.size()) return NodeStatus::running;
    break;
  }
  return all_skipped_ ? NodeStatus::skipped : NodeStatus::failed;
}

bool TryNode::on_halt(TaskCycle& cycle) {
  return index_ >= children_.size() || children_[index_]->halt(cycle);
}

}  // namespace striate::tasks
