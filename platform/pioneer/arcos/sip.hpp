#pragma once

#include <optional>
#include <vector>

#include "striate/platform/pioneer/arcos/packet.hpp"

namespace striate::pioneer::arcos {

/// A sonar reading that is new in this packet; in units of the robot's range factor (mm).
struct SonarReading {
  std::uint8_t disc = 0;
  std::uint16_t range = 0;
};

/// Bits of Sip::flags.
struct SipFlag {
  static constexpr std::uint16_t motors_on = 1U << 0;
  static constexpr std::uint16_t sonar_on = 0x1eU;  ///< one bit an array
  static constexpr std::uint16_t stop_pressed = 1U << 5;
  static constexpr std::uint16_t emergency_stall = 1U << 6;
  static constexpr std::uint16_t joystick_button = 1U << 9;
};

/// The packet a robot sends about itself every cycle (100 ms), in the robot's own units. What older
/// firmware leaves out at the end is an empty optional.
struct Sip {
  std::uint8_t type = 0x32;  ///< 0x32 or 0x33, which must not be taken for standing or moving
  std::uint16_t x = 0;       ///< 15 bits, wraps; times the distance factor: mm
  std::uint16_t y = 0;
  std::int16_t heading = 0;  ///< 2 pi / 4096
  std::int16_t left_mm_s = 0;
  std::int16_t right_mm_s = 0;
  std::uint8_t battery_dv = 0;          ///< 0.1 V
  std::uint16_t stall_and_bumpers = 0;  ///< bits 0, 8: stall left, right; 1-7 rear, 9-15 front
  std::int16_t control = 0;
  std::uint16_t flags = 0;
  std::uint8_t compass = 0;
  std::vector<SonarReading> sonar;

  std::uint8_t gripper = 0;
  std::uint8_t analog_port = 0;
  std::uint8_t analog = 0;
  std::uint8_t digital_in = 0;
  std::uint8_t digital_out = 0;
  std::optional<std::uint16_t> battery_x10_dv;  ///< 0.1 V, up to higher voltages
  std::optional<std::uint8_t> charge_state;
  std::optional<std::int16_t> rotation_ddeg_s;  ///< 0.1 deg/s
  std::optional<std::uint16_t> faults;
  std::optional<std::int16_t> lateral_mm_s;
  std::optional<std::int8_t> temperature_c;
  std::optional<std::uint8_t> charge_percent;
};

[[nodiscard]] bool is_sip(const Packet& packet);
/// Empty when the packet is no SIP or too short to be one.
[[nodiscard]] std::optional<Sip> read_sip(const Packet& packet);
/// With the whole tail; what is empty goes as "unknown".
[[nodiscard]] Packet write_sip(const Sip& sip);

}  // namespace striate::pioneer::arcos
