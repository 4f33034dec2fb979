#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "platform/replay/bytes.hpp"

/// The frame of a recording: a head of the file, then chunks, each with its checksums.
namespace striate::replay {

static_assert(std::endian::native == std::endian::little, "a recording is little-endian");

/// First bytes of a recording (ours)
inline constexpr std::string_view kMagic = "striate recording\n";
inline constexpr std::uint32_t kVersion = 1;  ///< of the layout; a reader refuses others
inline constexpr std::size_t kFileHead_bytes = kMagic.size() + 4;  ///< magic and version
/// Kind, size and two checksums of 4 bytes each
inline constexpr std::size_t kChunkHead_bytes = 16;
/// A cycle's two pictures of 8192 x 4096 px; more is damage, not a size to allocate
inline constexpr std::uint32_t kMostChunk_bytes = 256U << 20U;

enum class Chunk : std::uint32_t { setup = 1, cycle = 2, end = 3 };

namespace detail {
constexpr std::array<std::uint32_t, 256> crc_table() {
  std::array<std::uint32_t, 256> table{};
  for (std::uint32_t byte = 0; byte < table.size(); ++byte) {
    std::uint32_t value = byte;
    for (int bit = 0; bit < 8; ++bit) value = (value >> 1) ^ ((value & 1) != 0 ? 0x82F63B78U : 0U);
    table[byte] = value;
  }
  return table;
}
}  // namespace detail

/// CRC-32C, as in the long-term memory; here by one table, which is fast beside the pictures' PNG.
[[nodiscard]] inline std::uint32_t checksum(std::span<const std::uint8_t> bytes) {
  static constexpr auto kTable = detail::crc_table();  ///< CRC-32C of every byte
  std::uint32_t crc = 0xFFFFFFFFU;
  for (const std::uint8_t byte : bytes) crc = (crc >> 8) ^ kTable[(crc ^ byte) & 0xFF];
  return ~crc;
}

/// The bytes that a new file begins with.
[[nodiscard]] inline std::vector<std::uint8_t> file_head() {
  std::vector<std::uint8_t> bytes(kMagic.begin(), kMagic.end());
  ByteWriter(bytes).put(kVersion);
  return bytes;
}

/// A chunk's head and payload: kind, size, checksum of the payload, checksum of the head.
inline void append_chunk(std::vector<std::uint8_t>& bytes, Chunk kind,
                         std::span<const std::uint8_t> payload) {
  std::vector<std::uint8_t> head;
  ByteWriter writer(head);
  writer.put(static_cast<std::uint32_t>(kind));
  writer.put(static_cast<std::uint32_t>(payload.size()));
  writer.put(checksum(payload));
  writer.put(checksum(head));
  bytes.insert(bytes.end(), head.begin(), head.end());
  bytes.insert(bytes.end(), payload.begin(), payload.end());
}

}  // namespace striate::replay
