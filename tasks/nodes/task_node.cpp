#include "striate/tasks/nodes/task_node.hpp"

#include <stdexcept>

namespace striate::tasks {
namespace {

NodeState ended_as(NodeStatus outcome) {
  if (outcome == NodeStatus::succeeded) return NodeState::succeeded;
  return outcome == NodeStatus::failed ? NodeState::failed : NodeState::skipped;
}

}  // namespace

void TaskNode::begin(TaskCycle& cycle) {
  if (state_ != State::idle) return;
  state_ = State::running;
  on_start(cycle);
}

NodeStatus TaskNode::tick(TaskCycle& cycle) {
  if (state_ == State::halting) throw std::logic_error("a node that is being halted was ticked");
  begin(cycle);
  const NodeStatus outcome = on_tick(cycle);
  if (outcome != NodeStatus::running) {
    state_ = State::idle;
    last_ = ended_as(outcome);
  }
  return outcome;
}

bool TaskNode::halt(TaskCycle& cycle) {
  if (state_ == State::idle) return true;
  if (asked_to_halt_in_ == cycle.number()) return false;
  asked_to_halt_in_ = cycle.number();
  state_ = State::halting;
  if (!on_halt(cycle)) return false;
  state_ = State::idle;
  last_ = NodeState::halted;
  return true;
}

}  // namespace striate::tasks
