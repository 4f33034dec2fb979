#include "tasks/nodes/limited_node.hpp"

namespace striate {

void LimitedNode::on_start(TaskCycle& cycle) {
  if (limits_.until) limits_.until->start(cycle.memory());
  started_ = cycle.now();
  pending_ = Outcome::running;
}

Outcome LimitedNode::on_tick(TaskCycle& cycle) {
  if (pending_ == Outcome::running) {
    const Outcome outcome = child_->tick(cycle);
    if (outcome != Outcome::running) return outcome;
    if (limits_.until && limits_.until->holds(cycle.memory())) {
      pending_ = Outcome::succeeded;
    } else if (limits_.within && cycle.now() - started_ > *limits_.within) {
      cycle.reason().set("{} (line {}) took longer than {:g} s", label_, line_,
                         to_seconds(*limits_.within));
      pending_ = Outcome::failed;
    } else {
      return Outcome::running;
    }
  }
  return child_->halt(cycle) ? pending_ : Outcome::running;
}

}  // namespace striate
