#include "striate/tasks/nodes/action_node.hpp"

namespace striate::tasks {

ActionNode::ActionNode(std::string name, int line, std::unique_ptr<behaviours::Behaviour> behaviour)
    : name_(std::move(name)),
      line_(line),
      behaviour_(std::move(behaviour)),
      motors_(behaviour_->motors()) {}

NodeStatus ActionNode::on_tick(TaskCycle& cycle) {
  const behaviours::Wish wanted = behaviour_->tick(cycle.memory());
  if (wanted.progress == behaviours::Progress::succeeded) return NodeStatus::succeeded;
  if (wanted.progress == behaviours::Progress::failed) {
    cycle.reason().set(wanted.failure, line_, "{} (line {}): {}", name_, line_, wanted.why.view());
    return NodeStatus::failed;
  }
  cycle.want(this, name_, motors_, wanted);
  return NodeStatus::running;
}

bool ActionNode::on_halt(TaskCycle& cycle) {
  cycle.release(this);
  return behaviour_->halt(cycle.memory());
}

}  // namespace striate::tasks
