#pragma once

#include <optional>
#include <string>

#include "striate/platform/pioneer/arcos/packet.hpp"

namespace striate::pioneer::arcos {

/// What a robot says about itself when it is asked (CONFIG, reply 0x20): its kind, limits, working
/// values and calibration. Firmware that knows fewer fields sends less; the rest is 0 and "".
struct ConfigPac {
  static constexpr std::uint8_t kId = 0x20;  ///< CONFIGpac's packet type; ARCOS manual

  std::string type, subtype, serial;
  std::uint8_t four_motors = 0;
  std::uint16_t rotation_top_deg_s = 0, velocity_top_mm_s = 0;
  std::uint16_t rotation_acceleration_top_deg_s2 = 0, acceleration_top_mm_s2 = 0;
  std::uint16_t pwm_max = 0;
  std::string name;
  std::uint8_t sip_cycle_ms = 0, host_baud = 0, aux1_baud = 0;
  std::uint16_t has_gripper = 0, front_sonar = 0;
  std::uint8_t rear_sonar = 0;
  std::uint16_t low_battery_dv = 0, rev_count = 0, watchdog_ms = 0;
  std::uint8_t p2m_packets = 0;
  std::uint16_t stall_value = 0, stall_count = 0, joystick_mm_s = 0, joystick_deg_s = 0;
  std::uint16_t rotation_max_deg_s = 0, velocity_max_mm_s = 0;
  std::uint16_t rotation_acceleration_deg_s2 = 0, rotation_deceleration_deg_s2 = 0;
  std::uint16_t rotation_kp = 0, rotation_kv = 0, rotation_ki = 0;
  std::uint16_t acceleration_mm_s2 = 0, deceleration_mm_s2 = 0;
  std::uint16_t velocity_kp = 0, velocity_kv = 0, velocity_ki = 0;
  std::uint8_t front_bumpers = 0, rear_bumpers = 0, charger = 0, sonar_cycle_ms = 0;
  std::uint8_t auto_baud = 0, has_gyro = 0;
  std::int16_t drift_factor = 0;
  std::uint8_t aux2_baud = 0, aux3_baud = 0;
  std::uint16_t ticks_mm = 0, shutdown_dv = 0;
  std::string firmware;
  std::uint16_t gyro_cw = 0, gyro_ccw = 0;
  std::uint8_t kinematics_delay_ms = 0;
};

/// Empty when the packet is no CONFIGpac or ends within the three names.
[[nodiscard]] std::optional<ConfigPac> read_config_pac(const Packet& packet);
[[nodiscard]] Packet write_config_pac(const ConfigPac& config);

}  // namespace striate::pioneer::arcos
