#include "striate/platform/pioneer/firmware/servo_bus.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "striate/base/pioneer_devices.hpp"

namespace striate::pioneer {

using dynamixel::Error;
using dynamixel::Instruction;
using dynamixel::Register;

namespace {

/// AX-12A data sheet: 59 rpm without load
constexpr double kFastestRad_s = 59.0 * 2.0 * std::numbers::pi / 60.0;
/// Blocked for so long it gives up, as an AX-12A does after some seconds (ours)
constexpr double kOverloadAfter_s = 2.0;
constexpr double kThere_rad = 0.003;  // half a step of the position, 0.293 deg

}  // namespace

ServoModel::ServoModel(std::uint8_t id, double angle_rad) : angle_rad_(angle_rad) {
  registers_[Register::model] = 12;
  registers_[Register::id] = id;
  set_word(Register::ccw_limit, 1023);
  set_word(Register::torque_limit, 1023);
  set_word(Register::goal_position, dynamixel::ticks_of(angle_rad));
  set_word(Register::position, dynamixel::ticks_of(angle_rad));
  registers_[Register::voltage] = 120;
  registers_[Register::temperature] = 35;
}

std::uint16_t ServoModel::word(std::uint8_t address) const {
  return static_cast<std::uint16_t>(registers_[address] | registers_[address + 1U] << 8U);
}

void ServoModel::set_word(std::uint8_t address, std::uint16_t value) {
  registers_[address] = static_cast<std::uint8_t>(value & 0xffU);
  registers_[address + 1U] = static_cast<std::uint8_t>(value >> 8U);
}

Bytes ServoModel::read(std::uint8_t address, std::size_t count) const {
  Bytes values;
  for (std::size_t i = address; i < std::min(registers_.size(), address + count); ++i) {
    values.push_back(registers_[i]);
  }
  return values;
}

void ServoModel::write(std::uint8_t address, ByteView values) {
  for (std::size_t i = 0; i < values.size() && address + i < registers_.size(); ++i) {
    registers_[address + i] = values[i];
  }
  if (address == Register::goal_position) registers_[Register::torque_enable] = 1;
  if (address == Register::torque_limit && word(Register::torque_limit) > 0) {
    errors_ = 0;
    pushing_s_ = 0.0;
    set_word(Register::goal_position, dynamixel::ticks_of(angle_rad_));
  }
}

void ServoModel::step(double dt_s) {
  const bool powered = registers_[Register::torque_enable] != 0 && word(Register::torque_limit) > 0;
  const double goal_rad = dynamixel::angle_of(word(Register::goal_position));
  const double left_rad = goal_rad - angle_rad_;
  const std::uint16_t ticks = word(Register::moving_speed);
  const double speed =
      ticks == 0 ? kFastestRad_s : std::min(ticks * kServoSpeedStep_rad_s, kFastestRad_s);
  const bool wants = powered && std::abs(left_rad) > kThere_rad;
  const double way = wants && !blocked ? std::clamp(left_rad, -speed * dt_s, speed * dt_s) : 0.0;
  angle_rad_ += way;
  speed_rad_s_ = way / dt_s;
  pushing_s_ = wants && blocked ? pushing_s_ + dt_s : 0.0;
  if (pushing_s_ > kOverloadAfter_s) {
    errors_ |= Error::overload;
    set_word(Register::torque_limit, 0);
  }
  set_word(Register::position, dynamixel::ticks_of(angle_rad_));
  set_word(Register::load, wants && blocked ? 1000 : 0);
  registers_[Register::moving] = way != 0.0 ? 1 : 0;
}

void ServoBus::receive(ByteView bytes) {
  stream_.push(bytes);
  while (const auto packet = stream_.next()) obey(*packet);
}

void ServoBus::step(Duration step) {
  for (ServoModel& servo : servos) servo.step(to_seconds(step));
}

Bytes ServoBus::take_output() {
  Bytes bytes;
  bytes.swap(output_);
  return bytes;
}

void ServoBus::write_all(const dynamixel::Packet& packet) {
  if (packet.parameters.size() < 2) return;
  const std::size_t size = packet.parameters[1];
  ByteView left = ByteView(packet.parameters).subspan(2);
  while (left.size() >= size + 1) {
    for (ServoModel& servo : servos) {
      if (servo.connected && servo.id() == left[0]) {
        servo.write(packet.parameters[0], left.subspan(1, size));
      }
    }
    left = left.subspan(size + 1);
  }
}

void ServoBus::obey(const dynamixel::Packet& packet) {
  const auto instruction = static_cast<Instruction>(packet.code);
  if (packet.id == dynamixel::kBroadcast) {
    if (instruction == Instruction::sync_write) write_all(packet);
    return;
  }
  for (ServoModel& servo : servos) {
    if (!servo.connected || servo.id() != packet.id) continue;
    dynamixel::Packet reply{packet.id, servo.errors(), {}};
    if (instruction == Instruction::read && packet.parameters.size() == 2) {
      reply.parameters = servo.read(packet.parameters[0], packet.parameters[1]);
    } else if (instruction == Instruction::write && packet.parameters.size() >= 2) {
      servo.write(packet.parameters[0], ByteView(packet.parameters).subspan(1));
    } else if (instruction != Instruction::ping) {
      reply.code |= Error::instruction;
    }
    append(output_, dynamixel::encode(reply));
  }
}

}  // namespace striate::pioneer
