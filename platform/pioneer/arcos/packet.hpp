#pragma once

#include <cstdint>

#include "striate/base/bytes.hpp"
#include "striate/base/time.hpp"

/// ARCOS, the Pioneer's serial protocol (also P2OS, AROS): FA FB | N | id | payload | checksum.
/// N counts what follows it: 1 + payload + 2. Payload numbers are little-endian, the checksum is
/// big-endian. The same bytes travel both ways.
namespace striate::pioneer::arcos {

inline constexpr std::size_t kMostPayload = 252;  ///< N is one unsigned byte

/// The longest packet takes 269 ms at 9600 baud; a count that promises more never comes true.
inline constexpr Duration kLongestPacket = std::chrono::milliseconds(280);

struct Packet {
  std::uint8_t id = 0;
  Bytes payload;
  friend bool operator==(const Packet&, const Packet&) = default;
};

/// Sum of byte pairs, first byte high; an odd last byte is XORed into the low byte.
/// @param body id and payload
[[nodiscard]] std::uint16_t checksum(ByteView body);

/// The whole packet as it goes over the wire.
/// @throws std::length_error when the payload is longer than kMostPayload.
[[nodiscard]] Bytes encode(const Packet& packet);

}  // namespace striate::pioneer::arcos
