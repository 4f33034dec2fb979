#pragma once

#include <cstdint>

namespace striate::pioneer {

/// Why the robot stands, or is slower than it was told to be.
enum class HoldReason : std::uint8_t {
  none,
  no_command,  ///< none is newer than the last gap
  command_old,
  line_late,  ///< commands, or what the robot says, are too long under way
  seen_old,   ///< what the command was decided by is too old when it would drive
  slowed,     ///< an echo is near
  obstacle,   ///< an echo is too near
  stalled,
  bumper,
  battery_low,
  laser_stale,
  head_fails,
  robot_silent,
  not_ready,   ///< no connection yet
  stopped,     ///< latched: the program was not running, or gave no command for too long
  link_lost,   ///< latched: there was a connection, it broke
  motors_off,  ///< latched: the robot has switched its motors off
  joystick,    ///< latched: somebody drives by hand
  emergency,   ///< latched
};
[[nodiscard]] const char* name_of(HoldReason reason);

}  // namespace striate::pioneer
