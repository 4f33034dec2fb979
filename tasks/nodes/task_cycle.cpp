#include "striate/tasks/nodes/task_cycle.hpp"

#include <stdexcept>

namespace striate::tasks {

void TaskCycle::want(const void* action, std::string_view name, behaviours::Motors motors,
                     const behaviours::Wish& wanted) {
  const bool wheels = behaviours::share(motors, behaviours::Motors::wheels);
  const bool head = behaviours::share(motors, behaviours::Motors::head);
  if ((wheels && wheels_of_ != nullptr) || (head && head_of_ != nullptr)) {
    throw std::logic_error("two actions want the same motors in one cycle");
  }
  if (wheels) {
    wish_.forward_m_s = wanted.forward_m_s;
    wish_.turn_rad_s = wanted.turn_rad_s;
    wheels_of_ = action;
  }
  if (head) {
    wish_.pan_rad = wanted.pan_rad;
    wish_.tilt_rad = wanted.tilt_rad;
    head_of_ = action;
  }
  if (wheels || wheels_of_ == nullptr) {
    wish_.why = wanted.why;
    doing_ = name;
  }
}

void TaskCycle::release(const void* action) {
  if (wheels_of_ != action && head_of_ != action) return;
  const behaviours::Wish standing = behaviours::standing_wish(memory_, "");
  if (wheels_of_ == action) {
    wish_.forward_m_s = 0.0;
    wish_.turn_rad_s = 0.0;
    wish_.why = standing.why;
    wheels_of_ = nullptr;
  }
  if (head_of_ == action) {
    wish_.pan_rad = standing.pan_rad;
    wish_.tilt_rad = standing.tilt_rad;
    head_of_ = nullptr;
  }
}

void TaskCycle::pause(const char* why) {
  paused_ = true;
  if (wheels_of_ == nullptr) wish_.why = why;
}

}  // namespace striate::tasks
