#include "striate/tasks/nodes/scope_node.hpp"

namespace striate::tasks {

void ScopeNode::on_start(TaskCycle& cycle) {
  phase_ = Phase::doing;
  outcome_ = NodeStatus::running;
  for (const Guard& guard : guards_) guard.condition->start(cycle.memory());
}

NodeStatus ScopeNode::on_tick(TaskCycle& cycle) {
  switch (phase_) {
    case Phase::doing:
      return tick_steps(cycle);
    case Phase::halting:
      return steps_->halt(cycle) ? begin_finally(cycle, NodeStatus::failed) : NodeStatus::running;
    case Phase::finally:
      break;
  }
  return tick_finally(cycle);
}

const Guard* ScopeNode::holding(TaskCycle& cycle) const {
  for (const Guard& guard : guards_) {
    if (guard.condition->holds(cycle.memory())) return &guard;
  }
  return nullptr;
}

NodeStatus ScopeNode::tick_steps(TaskCycle& cycle) {
  if (const Guard* guard = holding(cycle)) {
    if (guard->kind == Guard::Kind::pause_if) {
      cycle.pause(guard->text.c_str());
      return NodeStatus::running;
    }
    cycle.reason().set(behaviours::Failure::guard, guard->line, "guard (line {}): {}", guard->line,
                       guard->text);
    phase_ = Phase::halting;
    return steps_->halt(cycle) ? begin_finally(cycle, NodeStatus::failed) : NodeStatus::running;
  }
  const NodeStatus outcome = steps_->tick(cycle);
  return outcome == NodeStatus::running ? outcome : begin_finally(cycle, outcome);
}

NodeStatus ScopeNode::begin_finally(TaskCycle& cycle, NodeStatus outcome) {
  outcome_ = outcome;
  if (!finally_) return outcome;
  finally_since_ = cycle.now();
  phase_ = Phase::finally;
  return NodeStatus::running;
}

NodeStatus ScopeNode::tick_finally(TaskCycle& cycle) {
  // Ticked and then halted by a node above in the same cycle: once is enough.
  if (ticked_in_ == cycle.number()) return NodeStatus::running;
  ticked_in_ = cycle.number();
  // Its own failures are no reason for how the steps ended.
  const Reason reason = cycle.reason();
  const bool too_long = cycle.now() - finally_since_ > kFinallyLimit;
  const bool over = too_long || finally_->tick(cycle) != NodeStatus::running;
  cycle.reason() = reason;
  return over && finally_->halt(cycle) ? outcome_ : NodeStatus::running;
}

bool ScopeNode::on_halt(TaskCycle& cycle) {
  if (phase_ != Phase::finally) {
    phase_ = Phase::halting;
    return steps_->halt(cycle) && begin_finally(cycle, NodeStatus::failed) != NodeStatus::running;
  }
  return tick_finally(cycle) != NodeStatus::running;
}

}  // namespace striate::tasks
