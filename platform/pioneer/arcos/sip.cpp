#include "striate/platform/pioneer/arcos/sip.hpp"

namespace striate::pioneer::arcos {
namespace {

constexpr std::size_t kHead = 19;  ///< payload up to and with the sonar count
/// Deg C: the robot does not know; ARCOS manual, standard SIP
constexpr std::int8_t kNoTemperature = -127;

void read_sonar(ByteReader& reader, Sip& sip) {
  const std::size_t count = reader.u8();
  // Simulators announce sixteen readings and send none just after the sonar was switched on.
  if (3 * count > reader.left()) return;
  sip.sonar.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint8_t disc = reader.u8();
    sip.sonar.push_back({disc, reader.u16()});
  }
}

template <class T, class Read>
void read_if(ByteReader& reader, std::optional<T>& field, Read read) {
  if (reader.left() >= sizeof(T)) field = read();
}

}  // namespace

bool is_sip(const Packet& packet) {
  return packet.id >= 0x30 && packet.id <= 0x34;
}

std::optional<Sip> read_sip(const Packet& packet) {
  if (!is_sip(packet) || packet.payload.size() < kHead) return std::nullopt;
  ByteReader reader(packet.payload, ByteReader::Beyond::zero);
  Sip sip;
  sip.type = packet.id;
  sip.x = reader.u16() & 0x7fffU;
  sip.y = reader.u16() & 0x7fffU;
  sip.heading = reader.i16();
  sip.left_mm_s = reader.i16();
  sip.right_mm_s = reader.i16();
  sip.battery_dv = reader.u8();
  sip.stall_and_bumpers = reader.u16();
  sip.control = reader.i16();
  sip.flags = reader.u16();
  sip.compass = reader.u8();
  read_sonar(reader, sip);
  sip.gripper = reader.u8();
  sip.analog_port = reader.u8();
  sip.analog = reader.u8();
  sip.digital_in = reader.u8();
  sip.digital_out = reader.u8();
  read_if(reader, sip.battery_x10_dv, [&] { return reader.u16(); });
  read_if(reader, sip.charge_state, [&] { return reader.u8(); });
  read_if(reader, sip.rotation_ddeg_s, [&] { return reader.i16(); });
  read_if(reader, sip.faults, [&] { return reader.u16(); });
  read_if(reader, sip.lateral_mm_s, [&] { return reader.i16(); });
  read_if(reader, sip.temperature_c, [&] { return reader.i8(); });
  read_if(reader, sip.charge_percent, [&] { return reader.u8(); });
  return sip;
}

Packet write_sip(const Sip& sip) {
  ByteWriter writer;
  writer.u16(sip.x & 0x7fffU);
  writer.u16(sip.y & 0x7fffU);
  writer.i16(sip.heading);
  writer.i16(sip.left_mm_s);
  writer.i16(sip.right_mm_s);
  writer.u8(sip.battery_dv);
  writer.u16(sip.stall_and_bumpers);
  writer.i16(sip.control);
  writer.u16(sip.flags);
  writer.u8(sip.compass);
  writer.u8(static_cast<std::uint8_t>(sip.sonar.size()));
  for (const SonarReading& reading : sip.sonar) {
    writer.u8(reading.disc);
    writer.u16(reading.range);
  }
  writer.u8(sip.gripper);
  writer.u8(sip.analog_port);
  writer.u8(sip.analog);
  writer.u8(sip.digital_in);
  writer.u8(sip.digital_out);
  writer.u16(sip.battery_x10_dv.value_or(sip.battery_dv));
  writer.u8(sip.charge_state.value_or(0xff));
  writer.i16(sip.rotation_ddeg_s.value_or(0));
  writer.u16(sip.faults.value_or(0));
  writer.i16(sip.lateral_mm_s.value_or(0));
  writer.i8(sip.temperature_c.value_or(kNoTemperature));
  writer.u8(sip.charge_percent.value_or(0));
  return {sip.type, writer.bytes()};
}

}  // namespace striate::pioneer::arcos
