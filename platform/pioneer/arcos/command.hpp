#pragma once

#include <optional>
#include <string>

#include "striate/platform/pioneer/arcos/packet.hpp"

/// Commands from program to robot: nothing, an int, two bytes or a string behind the id.
namespace striate::pioneer::arcos {

enum class Command : std::uint8_t {
  sync0 = 0,
  sync1 = 1,
  sync2 = 2,
  pulse = 0,  ///< once connected: nothing but a sign of life
  open = 1,
  close = 2,
  polling = 3,
  enable = 4,
  set_acceleration = 5,  ///< mm/s2; negative: deceleration
  set_velocity = 6,      ///< mm/s, the most
  set_origin = 7,
  move = 8,                ///< mm
  rotate = 9,              ///< deg/s, as rotation_velocity
  set_rotation = 10,       ///< deg/s, the most
  velocity = 11,           ///< mm/s
  heading = 12,            ///< deg, absolute
  turn = 13,               ///< deg, relative
  joystick_info = 17,      ///< 0 stop, 1 once, 2 stream
  config = 18,             ///< asks for the CONFIGpac
  encoder = 19,            ///< 0 stop, 1 once, 2 stream
  rotation_velocity = 21,  ///< deg/s, counter-clockwise
  turn_on = 22,            ///< deg, relative to the last set-point
  set_rotation_acceleration = 23,
  sonar = 28,
  stop = 29,
  digital_out = 30,      ///< low byte the values, high byte which of them are meant
  wheels = 32,           ///< VEL2: low byte right, high byte left, 20 mm/s each
  laser_mode = 35,       ///< simulators: 0 stop, 1 ranges alone, 2 with reflectance
  laser_start = 36,      ///< deg, counter-clockwise, of the first reading
  laser_end = 37,        ///< deg, of the last one
  laser_increment = 38,  ///< deg / 100
  io_request = 40,       ///< 0 stop, 1 once, 2 stream
  bump_stall = 44,
  joystick_drive = 47,
  sonar_cycle = 48,
  host_baud = 50,
  emergency_stop = 55,
  emergency_stall = 56,
  quick_stop = 57,
  gyro = 58,                  ///< 0 stop, 1 stream
  battery_info = 62,          ///< 0 stop, 1 once, 2 stream
  sim_set_pose = 224,         ///< x, y in mm, heading in deg, 32 bits each: the true pose
  sim_reset = 225,            ///< back to where it began, odometry 0
  sim_laser_mode = 230,       ///< as laser_mode
  sim_laser_start = 231,      ///< as laser_start
  sim_laser_end = 232,        ///< as laser_end
  sim_laser_increment = 233,  ///< as laser_increment
  sim_stat = 237,
  battery_test = 250,
  reset = 253,  ///< the controller begins anew
};

/// VEL2's unit.
inline constexpr int kWheelUnitMm_s = 20;

[[nodiscard]] Bytes command(Command id);
/// @param argument clamped to +-32767; the sign goes into the type byte.
[[nodiscard]] Bytes command(Command id, int argument);
[[nodiscard]] Bytes command(Command id, std::uint8_t low, std::uint8_t high);
[[nodiscard]] Bytes command(Command id, const std::string& text);

/// What stands behind a command's id, read leniently: clients send a type byte without a value, and
/// positive values beyond 32767 that mean negative ones.
struct Argument {
  bool present = false;
  int value = 0;
  std::uint8_t low = 0;
  std::uint8_t high = 0;
  std::string text;
};
[[nodiscard]] Argument read_argument(const Packet& packet);
/// The pose behind sim_set_pose, with or without a type byte; x and y in mm, heading in deg. Empty:
/// too short.
struct SimPose {
  std::int32_t x_mm = 0;
  std::int32_t y_mm = 0;
  std::int32_t heading_deg = 0;
};
[[nodiscard]] std::optional<SimPose> read_sim_pose(const Packet& packet);

}  // namespace striate::pioneer::arcos
