#include "tasks/nodes/action_node.hpp"

namespace striate {

ActionNode::ActionNode(std::string name, int line, std::unique_ptr<Behaviour> behaviour)
    : name_(std::move(name)),
      line_(line),
      behaviour_(std::move(behaviour)),
      motors_(behaviour_->motors()) {}

Outcome ActionNode::on_tick(TaskCycle& cycle) {
  const Wish wanted = behaviour_->tick(cycle.memory());
  if (wanted.progress == Progress::succeeded) return Outcome::succeeded;
  if (wanted.progress == Progress::failed) {
    cycle.reason().set("{} (line {}): {}", name_, line_, wanted.why.view());
    return Outcome::failed;
  }
  cycle.want(this, name_, motors_, wanted);
  return Outcome::running;
}

bool ActionNode::on_halt(TaskCycle& cycle) {
  cycle.release(this);
  return behaviour_->halt(cycle.memory());
}

}  // namespace striate
