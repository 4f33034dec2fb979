#include "striate/tasks/nodes/limited_node.hpp"

namespace striate::tasks {

void LimitedNode::on_start(TaskCycle& cycle) {
  if (limits_.until) limits_.until->start(cycle.memory());
  started_ = cycle.now();
  pending_ = NodeStatus::running;
}

NodeStatus LimitedNode::on_tick(TaskCycle& cycle) {
  if (pending_ == NodeStatus::running) {
    const NodeStatus outcome = child_->tick(cycle);
    if (outcome != NodeStatus::running) return outcome;
    if (limits_.until && limits_.until->holds(cycle.memory())) {
      pending_ = NodeStatus::succeeded;
    } else if (limits_.within && cycle.now() - started_ > *limits_.within) {
      cycle.reason().set(behaviours::Failure::took_too_long, line_,
                         "{} (line {}) took longer than {:g} s", label_, line_,
                         to_seconds(*limits_.within));
      pending_ = NodeStatus::failed;
    } else {
      return NodeStatus::running;
    }
  }
  return child_->halt(cycle) ? pending_ : NodeStatus::running;
}

}  // namespace striate::tasks
