#include "tasks/nodes/try_node.hpp"

namespace striate {

void TryNode::on_start(TaskCycle& /*cycle*/) {
  index_ = 0;
  all_skipped_ = true;
}

Outcome TryNode::on_tick(TaskCycle& cycle) {
  for (; index_ < children_.size(); ++index_) {
    const Outcome outcome = children_[index_]->tick(cycle);
    if (outcome == Outcome::skipped) continue;
    all_skipped_ = false;
    if (outcome != Outcome::failed) return outcome;
    // One action a cycle: the next alternative waits for the next cycle.
    if (++index_ < children_.size()) return Outcome::running;
    break;
  }
  return all_skipped_ ? Outcome::skipped : Outcome::failed;
}

bool TryNode::on_halt(TaskCycle& cycle) {
  return index_ >= children_.size() || children_[index_]->halt(cycle);
}

}  // namespace striate
