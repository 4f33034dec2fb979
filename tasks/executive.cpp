#include "striate/tasks/executive.hpp"

#include <stdexcept>
#include <utility>

namespace striate::tasks {
namespace {

MissionState state_of(NodeStatus outcome) {
  switch (outcome) {
    case NodeStatus::running:
      return MissionState::running;
    case NodeStatus::failed:
      return MissionState::failed;
    case NodeStatus::succeeded:
    case NodeStatus::skipped:
      break;
  }
  return MissionState::succeeded;
}

}  // namespace

Executive::Executive(Task task) : task_(std::move(task)) {
  if (!task_.root) throw std::logic_error("an executive needs a task with a tree");
}

TaskDecision Executive::tick(const memory::ShortTermMemory& memory, TimePoint now) {
  TaskCycle cycle(memory, now, reason_, ++cycles_);
  if (!ended_) advance(cycle);
  doing_ = cycle.doing();
  const bool guarded = cycle.paused() && doing_.empty();
  return {
      {guarded ? behaviours::MotorOwner::guard : behaviours::MotorOwner::behaviour, cycle.wish()},
      doing_,
      ended_};
}

void Executive::advance(TaskCycle& cycle) {
  task_.root->begin(cycle);
  if (interrupted_) {
    ended_ = task_.root->halt(cycle);
    if (task_.root->steps_outcome() != NodeStatus::running) state_ = interrupted_as_;
    return;
  }
  ended_ = task_.root->tick(cycle) != NodeStatus::running;
  state_ = state_of(task_.root->steps_outcome());
}

void Executive::interrupt(MissionState as, std::string reason) {
  // What has ended already has ended, `finally` is on its way.
  if (ended_ || interrupted_ || state_ != MissionState::running) return;
  interrupted_ = true;
  interrupted_as_ = as;
  interrupted_why_ = std::move(reason);
}

std::string Executive::reason() const {
  if (interrupted_) return interrupted_why_;
  return state_ == MissionState::succeeded ? std::string() : std::string(reason_.view());
}

}  // namespace striate::tasks
