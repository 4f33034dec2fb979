#include "striate/platform/pioneer/arcos/packet.hpp"

#include <stdexcept>

namespace striate::pioneer::arcos {

std::uint16_t checksum(ByteView body) {
  std::uint32_t sum = 0;
  std::size_t i = 0;
  for (; i + 1 < body.size(); i += 2) {
    sum = (sum + (std::uint32_t{body[i]} << 8 | body[i + 1])) & 0xffffU;
  }
  if (i < body.size()) sum ^= body[i];
  return static_cast<std::uint16_t>(sum);
}

Bytes encode(const Packet& packet) {
  if (packet.payload.size() > kMostPayload) {
    throw std::length_error("an ARCOS packet holds no more than 252 bytes of payload");
  }
  Bytes bytes{0xfa, 0xfb, static_cast<std::uint8_t>(packet.payload.size() + 3), packet.id};
  append(bytes, packet.payload);
  const std::uint16_t sum = checksum(ByteView(bytes).subspan(3));
  bytes.push_back(static_cast<std::uint8_t>(sum >> 8));
  bytes.push_back(static_cast<std::uint8_t>(sum & 0xff));
  return bytes;
}

}  // namespace striate::pioneer::arcos
