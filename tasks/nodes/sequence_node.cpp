#include "striate/tasks/nodes/sequence_node.hpp"

namespace striate::tasks {

void SequenceNode::on_start(TaskCycle& /*cycle*/) {
  index_ = 0;
  all_skipped_ = true;
}

NodeStatus SequenceNode::on_tick(TaskCycle& cycle) {
  for (; index_ < children_.size(); ++index_) {
    const NodeStatus outcome = children_[index_]->tick(cycle);
    if (outcome == NodeStatus::skipped) continue;
    all_skipped_ = false;
    if (outcome == NodeStatus::running) return NodeStatus::running;
    if (outcome == NodeStatus::failed && !keep_going_) return NodeStatus::failed;
    // One action a cycle: the next child waits for the next cycle.
    if (++index_ < children_.size()) return NodeStatus::running;
    break;
  }
  return all_skipped_ && !children_.empty() ? NodeStatus::skipped : NodeStatus::succeeded;
}

bool SequenceNode::on_halt(TaskCycle& cycle) {
  return index_ >= children_.size() || children_[index_]->halt(cycle);
}

}  // namespace striate::tasks
