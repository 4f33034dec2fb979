#include "striate/platform/pioneer/arcos/other_packets.hpp"

#include <algorithm>

namespace striate::pioneer::arcos {

std::optional<RobotNames> read_names(const Packet& packet) {
  if (packet.id != 2) return std::nullopt;
  ByteReader reader(packet.payload, ByteReader::Beyond::zero);
  RobotNames names;
  names.name = reader.take_c_string();
  names.kind = reader.take_c_string();
  names.subclass = reader.take_c_string();
  // An echo of SYNC2 without names is none; a missing last NUL is forgiven.
  if (names.subclass.empty()) return std::nullopt;
  return names;
}

Packet write_names(const RobotNames& names) {
  ByteWriter writer;
  writer.put_c_string(names.name);
  writer.put_c_string(names.kind);
  writer.put_c_string(names.subclass);
  return {2, writer.bytes()};
}

std::optional<Joystick> read_joystick(const Packet& packet) {
  if (packet.id != Joystick::kId) return std::nullopt;
  ByteReader reader(packet.payload, ByteReader::Beyond::zero);
  Joystick joystick;
  joystick.button1 = reader.u8() != 0;
  joystick.button2 = reader.u8() != 0;
  joystick.x = reader.u16();
  joystick.y = reader.u16();
  joystick.throttle = reader.u16();
  if (reader.ran_out()) return std::nullopt;
  return joystick;
}

Packet write_joystick(const Joystick& joystick) {
  ByteWriter writer;
  writer.u8(joystick.button1 ? 1 : 0);
  writer.u8(joystick.button2 ? 1 : 0);
  writer.u16(joystick.x);
  writer.u16(joystick.y);
  writer.u16(joystick.throttle);
  return {Joystick::kId, writer.bytes()};
}

Packet write_encoders(const Encoders& encoders) {
  ByteWriter writer;
  writer.i32(encoders.left_ticks);
  writer.i32(encoders.right_ticks);
  return {Encoders::kId, writer.bytes()};
}

Packet write_io(const IoPac& io) {
  constexpr int kAnalogPorts = 8;  // of the controller's user connector; ARCOS manual
  ByteWriter writer;
  writer.u8(4);
  for (const std::uint8_t byte : {io.digital_in, io.front_bumpers, io.rear_bumpers}) {
    writer.u8(byte);
  }
  writer.u8(0);  // infrared
  writer.u8(1);
  writer.u8(io.digital_out);
  writer.u8(kAnalogPorts);
  for (int i = 0; i < kAnalogPorts; ++i) writer.u16(0);
  return {IoPac::kId, writer.bytes()};
}

Packet write_battery(const BatteryPac& battery) {
  ByteWriter writer;
  writer.u8(1);                              // batteries
  writer.u8(5);                              // bytes of each
  for (int i = 0; i < 3; ++i) writer.u8(0);  // flags
  writer.u8(battery.charge_percent);         // relative, then absolute
  writer.u8(battery.charge_percent);
  return {BatteryPac::kId, writer.bytes()};
}

Packet write_gyro(const GyroPac& gyro) {
  ByteWriter writer;
  writer.u8(static_cast<std::uint8_t>(gyro.readings.size()));
  for (const std::int16_t reading : gyro.readings) {
    writer.i16(reading);
    writer.u8(GyroPac::kTemperature);
  }
  return {GyroPac::kId, writer.bytes()};
}

std::optional<SimStat> read_sim_stat(const Packet& packet) {
  if (packet.id != SimStat::kId) return std::nullopt;
  ByteReader reader(packet.payload, ByteReader::Beyond::zero);
  (void)reader.u16();  // two NULs
  (void)reader.u32();  // flags
  (void)reader.u16();  // intervals: simulated, real, last
  (void)reader.u32();
  SimStat stat;
  stat.x_mm = reader.i32();
  stat.y_mm = reader.i32();
  (void)reader.i32();
  stat.heading_deg = reader.i32();
  if (reader.ran_out()) return std::nullopt;
  return stat;
}

Packet write_sim_stat(const SimStat& stat) {
  ByteWriter writer;
  writer.u16(0);
  writer.u32(0);
  for (int i = 0; i < 3; ++i) writer.u16(100);
  writer.i32(stat.x_mm);
  writer.i32(stat.y_mm);
  writer.i32(0);
  writer.i32(stat.heading_deg);
  for (int i = 0; i < 3; ++i) writer.i32(0);  // latitude, longitude, altitude: none
  writer.u8(0);
  for (int i = 0; i < 3; ++i) writer.i32(0);  // odometry's error is not told
  return {SimStat::kId, writer.bytes()};
}

std::optional<SimLaser> read_sim_laser(const Packet& packet) {
  if (packet.id != SimLaser::kId) return std::nullopt;
  ByteReader reader(packet.payload, ByteReader::Beyond::zero);
  SimLaser laser;
  laser.total = reader.u16();
  laser.first = reader.u16();
  const std::size_t count = reader.u8();
  if (reader.ran_out() || 5 * count > reader.left()) return std::nullopt;
  for (std::size_t i = 0; i < count; ++i) {
    laser.ranges_mm.push_back(reader.u16());
    (void)reader.u8();   // reflectance
    (void)reader.u16();  // flags
  }
  return laser;
}

bool SimLaserSweep::take(const SimLaser& part) {
  if (part.first == 0) {
    next_ = 0;
    ranges_mm_.assign(part.total, 0);
  }
  const std::size_t end = part.first + part.ranges_mm.size();
  if (part.first != next_ || part.total != ranges_mm_.size() || end > ranges_mm_.size()) {
    next_ = ranges_mm_.size() + 1;  // wait for the next sweep
    return false;
  }
  std::copy(part.ranges_mm.begin(), part.ranges_mm.end(), ranges_mm_.begin() + part.first);
  next_ = end;
  return end == ranges_mm_.size() && !part.ranges_mm.empty();
}

std::vector<Packet> write_sim_laser(const std::vector<std::uint16_t>& ranges_mm) {
  std::vector<Packet> packets;
  for (std::size_t first = 0; first < ranges_mm.size(); first += SimLaser::kMostReadings) {
    const std::size_t count = std::min(SimLaser::kMostReadings, ranges_mm.size() - first);
    ByteWriter writer;
    writer.u16(static_cast<std::uint16_t>(ranges_mm.size()));
    writer.u16(static_cast<std::uint16_t>(first));
    writer.u8(static_cast<std::uint8_t>(count));
    for (std::size_t i = 0; i < count; ++i) {
      writer.u16(ranges_mm[first + i]);
      writer.u8(0);
      writer.u16(0);
    }
    writer.u8(0);
    writer.u8(0);
    packets.push_back({SimLaser::kId, writer.bytes()});
  }
  return packets;
}

std::vector<Packet> write_old_sim_laser(const OldSimLaser& at,
                                        const std::vector<std::uint16_t>& ranges_mm) {
  std::vector<Packet> packets;
  for (std::size_t first = 0; first < ranges_mm.size(); first += SimLaser::kMostReadings) {
    const std::size_t count = std::min(SimLaser::kMostReadings, ranges_mm.size() - first);
    ByteWriter writer;
    for (const std::int16_t value : {at.x, at.y, at.heading}) writer.i16(value);
    writer.u16(static_cast<std::uint16_t>(ranges_mm.size()));
    writer.u16(static_cast<std::uint16_t>(first));
    writer.u8(static_cast<std::uint8_t>(count));
    for (std::size_t i = 0; i < count; ++i) writer.u16(ranges_mm[first + i]);
    packets.push_back({OldSimLaser::kId, writer.bytes()});
  }
  return packets;
}

}  // namespace striate::pioneer::arcos
