#include "striate/platform/pioneer/turret/dynamixel.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "striate/base/pioneer_devices.hpp"

namespace striate::pioneer::dynamixel {
namespace {

constexpr std::uint8_t kStart = 0xff;  // first two bytes of a packet; Dynamixel protocol 1.0
/// Length, parameters + 2, is a byte, and 255 and 254 are ids; Dynamixel protocol 1.0
constexpr std::size_t kMostParameters = 250;
constexpr std::size_t kMostBadSums = 16;  // packets that one read of a line holds (ours)
constexpr double kMiddle = 512.0;         // AX-12A control table: tick that looks straight ahead
constexpr double kMostTicks = 1023.0;     // AX-12A control table: ten bits of position or speed

std::uint8_t sum_of(ByteView body) {
  unsigned sum = 0;
  for (const std::uint8_t byte : body) sum += byte;
  return static_cast<std::uint8_t>(~sum & 0xffU);
}

Packet instruct(std::uint8_t id, Instruction instruction, Bytes parameters) {
  return {id, static_cast<std::uint8_t>(instruction), std::move(parameters)};
}

}  // namespace

Bytes encode(const Packet& packet) {
  if (packet.parameters.size() > kMostParameters) {
    throw std::length_error("a Dynamixel packet holds no more than 250 parameters");
  }
  ByteWriter writer;
  writer.u8(kStart);
  writer.u8(kStart);
  writer.u8(packet.id);
  writer.u8(static_cast<std::uint8_t>(packet.parameters.size() + 2));
  writer.u8(packet.code);
  for (const std::uint8_t byte : packet.parameters) writer.u8(byte);
  writer.u8(sum_of(ByteView(writer.bytes()).subspan(2)));
  return writer.bytes();
}

void PacketStream::push(ByteView bytes) {
  buffer_.erase(buffer_.begin(), buffer_.begin() + static_cast<std::ptrdiff_t>(at_));
  at_ = 0;
  append(buffer_, bytes);
}

void PacketStream::skip_byte() {
  ++at_;
  ++counters_.junk_bytes;
}

void PacketStream::give_up_waiting() {
  if (waiting()) skip_byte();
}

std::optional<Packet> PacketStream::next() {
  while (at_ < buffer_.size()) {
    const ByteView left = ByteView(buffer_).subspan(at_);
    if (left[0] != kStart || (left.size() > 1 && left[1] != kStart)) {
      skip_byte();
      continue;
    }
    // A third FF is no id: the packet begins a byte later.
    if (left.size() > 2 && left[2] == kStart) {
      skip_byte();
      continue;
    }
    if (left.size() < 4) return std::nullopt;
    const std::size_t size = left[3];
    if (size < 2 || size > kMostParameters + 2) {
      ++counters_.bad_length;
      skip_byte();
      continue;
    }
    if (left.size() < size + 4) return std::nullopt;
    if (sum_of(left.subspan(2, size + 1)) != left[size + 3]) {
      ++counters_.bad_sum;
      // Nobody asks at the program's end: there it must not grow.
      if (bad_sums_.size() < kMostBadSums) bad_sums_.push_back(left[2]);
      skip_byte();
      continue;
    }
    ++counters_.packets;
    const ByteView parameters = left.subspan(5, size - 2);
    at_ += size + 4;
    return Packet{left[2], left[4], Bytes(parameters.begin(), parameters.end())};
  }
  return std::nullopt;
}

Bytes ping(std::uint8_t id) {
  return encode(instruct(id, Instruction::ping, {}));
}

Bytes read(std::uint8_t id, std::uint8_t address, std::uint8_t count) {
  return encode(instruct(id, Instruction::read, {address, count}));
}

Bytes write_byte(std::uint8_t id, std::uint8_t address, std::uint8_t value) {
  return encode(instruct(id, Instruction::write, {address, value}));
}

Bytes write_word(std::uint8_t id, std::uint8_t address, std::uint16_t value) {
  return encode(instruct(
      id, Instruction::write,
      {address, static_cast<std::uint8_t>(value & 0xff), static_cast<std::uint8_t>(value >> 8)}));
}

Bytes move(const std::vector<Goal>& goals) {
  ByteWriter writer;
  writer.u8(Register::goal_position);
  writer.u8(4);  // bytes for each servo: goal and speed
  for (const Goal& goal : goals) {
    writer.u8(goal.id);
    writer.u16(ticks_of(goal.angle_rad));
    writer.u16(speed_ticks_of(goal.speed_rad_s));
  }
  return encode(instruct(kBroadcast, Instruction::sync_write, writer.bytes()));
}

std::uint16_t ticks_of(double angle_rad) {
  if (!std::isfinite(angle_rad)) return static_cast<std::uint16_t>(kMiddle);
  return static_cast<std::uint16_t>(
      std::lround(std::clamp(kMiddle + angle_rad / kServoStep_rad, 0.0, kMostTicks)));
}

double angle_of(std::uint16_t ticks) {
  return (ticks - kMiddle) * kServoStep_rad;
}

std::uint16_t speed_ticks_of(double speed_rad_s) {
  if (!std::isfinite(speed_rad_s)) return 1;
  return static_cast<std::uint16_t>(
      std::lround(std::clamp(speed_rad_s / kServoSpeedStep_rad_s, 1.0, kMostTicks)));
}

}  // namespace striate::pioneer::dynamixel
