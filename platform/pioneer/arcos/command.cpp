#include "striate/platform/pioneer/arcos/command.hpp"

#include <algorithm>
#include <cstdlib>

namespace striate::pioneer::arcos {
namespace {

/// Argument type: int, not negative; ARCOS manual, command packets
constexpr std::uint8_t kPositive = 0x3b;
/// Argument type: absolute value of a negative int; ARCOS manual, command packets
constexpr std::uint8_t kNegative = 0x1b;
/// Argument type: string with its length; ARCOS manual, command packets
constexpr std::uint8_t kText = 0x2b;

Bytes typed(Command id, std::uint8_t type, std::uint8_t low, std::uint8_t high) {
  return encode({static_cast<std::uint8_t>(id), {type, low, high}});
}

}  // namespace

Bytes command(Command id) {
  return encode({static_cast<std::uint8_t>(id), {}});
}

Bytes command(Command id, int argument) {
  const int value = std::clamp(argument, -32767, 32767);
  const int size = std::abs(value);
  return typed(id, value < 0 ? kNegative : kPositive, static_cast<std::uint8_t>(size & 0xff),
               static_cast<std::uint8_t>(size >> 8));
}

Bytes command(Command id, std::uint8_t low, std::uint8_t high) {
  return typed(id, kPositive, low, high);
}

Bytes command(Command id, const std::string& text) {
  Packet packet{static_cast<std::uint8_t>(id), {kText}};
  const std::size_t size = std::min<std::size_t>(text.size(), 200);
  packet.payload.push_back(static_cast<std::uint8_t>(size));
  for (std::size_t i = 0; i < size; ++i) {
    packet.payload.push_back(static_cast<std::uint8_t>(text[i]));
  }
  return encode(packet);
}

Argument read_argument(const Packet& packet) {
  Argument argument;
  const Bytes& payload = packet.payload;
  if (payload.size() < 2) return argument;
  if (payload[0] == kText) {
    const std::size_t size = std::min<std::size_t>(payload[1], payload.size() - 2);
    argument.present = true;
    argument.text.assign(payload.begin() + 2,
                         payload.begin() + 2 + static_cast<std::ptrdiff_t>(size));
    return argument;
  }
  if (payload.size() < 3 || (payload[0] != kPositive && payload[0] != kNegative)) return argument;
  argument.present = true;
  argument.low = payload[1];
  argument.high = payload[2];
  const int size = payload[1] | payload[2] << 8;
  if (payload[0] == kNegative) {
    argument.value = -size;
  } else {
    argument.value = size > 32767 ? size - 65536 : size;
  }
  return argument;
}

std::optional<SimPose> read_sim_pose(const Packet& packet) {
  constexpr std::size_t kSize = 12;  // bytes of three 32-bit numbers
  if (packet.payload.size() < kSize) return std::nullopt;
  const bool typed = packet.payload.size() > kSize;
  ByteReader reader(ByteView(packet.payload).subspan(typed ? 1 : 0));
  SimPose pose;
  pose.x_mm = reader.i32();
  pose.y_mm = reader.i32();
  pose.heading_deg = reader.i32();
  return pose;
}

}  // namespace striate::pioneer::arcos
