#include "striate/platform/pioneer/arcos/config_pac.hpp"

namespace striate::pioneer::arcos {
namespace {

struct Read {
  ByteReader& reader;
  void operator()(std::string& field) { field = reader.take_c_string(); }
  void operator()(std::uint8_t& field) { field = reader.u8(); }
  void operator()(std::uint16_t& field) { field = reader.u16(); }
  void operator()(std::int16_t& field) { field = reader.i16(); }
};

struct Write {
  ByteWriter& writer;
  void operator()(const std::string& field) { writer.put_c_string(field); }
  void operator()(std::uint8_t field) { writer.u8(field); }
  void operator()(std::uint16_t field) { writer.u16(field); }
  void operator()(std::int16_t field) { writer.i16(field); }
};

/// The fields in the order of the wire: the one list for reading and writing.
template <class Each, class Config>
void each_field(Each each, Config& c) {
  const auto all = [&each](auto&... fields) { (each(fields), ...); };
  all(c.type, c.subtype, c.serial, c.four_motors, c.rotation_top_deg_s, c.velocity_top_mm_s,
      c.rotation_acceleration_top_deg_s2, c.acceleration_top_mm_s2, c.pwm_max, c.name,
      c.sip_cycle_ms, c.host_baud, c.aux1_baud, c.has_gripper, c.front_sonar, c.rear_sonar);
  all(c.low_battery_dv, c.rev_count, c.watchdog_ms, c.p2m_packets, c.stall_value, c.stall_count,
      c.joystick_mm_s, c.joystick_deg_s, c.rotation_max_deg_s, c.velocity_max_mm_s,
      c.rotation_acceleration_deg_s2, c.rotation_deceleration_deg_s2, c.rotation_kp, c.rotation_kv,
      c.rotation_ki, c.acceleration_mm_s2, c.deceleration_mm_s2, c.velocity_kp, c.velocity_kv,
      c.velocity_ki);
  all(c.front_bumpers, c.rear_bumpers, c.charger, c.sonar_cycle_ms, c.auto_baud, c.has_gyro,
      c.drift_factor, c.aux2_baud, c.aux3_baud, c.ticks_mm, c.shutdown_dv, c.firmware, c.gyro_cw,
      c.gyro_ccw, c.kinematics_delay_ms);
}

}  // namespace

std::optional<ConfigPac> read_config_pac(const Packet& packet) {
  if (packet.id != ConfigPac::kId) return std::nullopt;
  ByteReader names(packet.payload, ByteReader::Beyond::zero);
  for (int i = 0; i < 3; ++i) (void)names.take_c_string();
  if (names.ran_out()) return std::nullopt;
  ConfigPac config;
  ByteReader reader(packet.payload, ByteReader::Beyond::zero);
  each_field(Read{reader}, config);
  return config;
}

Packet write_config_pac(const ConfigPac& config) {
  ByteWriter writer;
  each_field(Write{writer}, config);
  return {ConfigPac::kId, writer.bytes()};
}

}  // namespace striate::pioneer::arcos
