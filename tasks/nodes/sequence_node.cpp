#include "tasks/nodes/sequence_node.hpp"

namespace striate {

void SequenceNode::on_start(TaskCycle& /*cycle*/) {
  index_ = 0;
  all_skipped_ = true;
}

Outcome SequenceNode::on_tick(TaskCycle& cycle) {
  for (; index_ < children_.size(); ++index_) {
    const Outcome outcome = children_[index_]->tick(cycle);
    if (outcome == Outcome::skipped) continue;
    all_skipped_ = false;
    if (outcome == Outcome::running) return Outcome::running;
    if (outcome == Outcome::failed && !keep_going_) return Outcome::failed;
    // One action a cycle: the next child waits for the next cycle.
    if (++index_ < children_.size()) return Outcome::running;
    break;
  }
  return all_skipped_ && !children_.empty() ? Outcome::skipped : Outcome::succeeded;
}

bool SequenceNode::on_halt(TaskCycle& cycle) {
  return index_ >= children_.size() || children_[index_]->halt(cycle);
}

}  // namespace striate
