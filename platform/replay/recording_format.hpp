#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "striate/base/bytes.hpp"
#include "striate/base/crc32c.hpp"

/// The frame of a recording: a head of the file, then chunks, each with its checksums (CRC-32C, as
/// in the long-term memory).
namespace striate::replay {

inline constexpr std::string_view kMagic = "striate recording\n";
inline constexpr std::uint32_t kVersion = 1;  ///< of the layout; a reader refuses others
inline constexpr std::size_t kFileHead_bytes = kMagic.size() + 4;  ///< magic and version
/// Kind, size and two checksums of 4 bytes each
inline constexpr std::size_t kChunkHead_bytes = 16;
/// A cycle's two images of 8192 x 4096 px; more is damage, not a size to allocate
inline constexpr std::uint32_t kMostChunk_bytes = 256U << 20U;

enum class Chunk : std::uint32_t { setup = 1, cycle = 2, end = 3 };

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
  writer.put(crc32c(payload));
  writer.put(crc32c(head));
  bytes.insert(bytes.end(), head.begin(), head.end());
  bytes.insert(bytes.end(), payload.begin(), payload.end());
}

}  // namespace striate::replay
