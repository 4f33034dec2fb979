#include "striate/platform/pioneer/hold_reason.hpp"

namespace striate::pioneer {

const char* name_of(HoldReason reason) {
  switch (reason) {
    case HoldReason::none:
      return "none";
    case HoldReason::no_command:
      return "no command since the last gap";
    case HoldReason::command_old:
      return "the command is old";
    case HoldReason::line_late:
      return "the line to the robot is late";
    case HoldReason::seen_old:
      return "what it has seen is too old";
    case HoldReason::slowed:
      return "an echo is near";
    case HoldReason::obstacle:
      return "an echo is too near";
    case HoldReason::stalled:
      return "the motors are stalled";
    case HoldReason::bumper:
      return "a bumper is pressed";
    case HoldReason::battery_low:
      return "the battery is low";
    case HoldReason::laser_stale:
      return "the laser is silent";
    case HoldReason::head_fails:
      return "the head does not obey";
    case HoldReason::robot_silent:
      return "the robot is silent";
    case HoldReason::not_ready:
      return "no connection";
    case HoldReason::stopped:
      return "the program stood still";
    case HoldReason::link_lost:
      return "the link broke";
    case HoldReason::motors_off:
      return "the robot has switched its motors off";
    case HoldReason::joystick:
      return "the joystick drives";
    case HoldReason::emergency:
      return "emergency stop";
  }
  return "";
}

}  // namespace striate::pioneer
