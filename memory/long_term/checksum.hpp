#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace striate {

/// CRC-32 as in zip, PNG and Python's zlib.crc32, eight bytes at a time.
/// @param before the checksum of what came earlier, to go on from; 0 at the start.
[[nodiscard]] std::uint32_t crc32(std::span<const std::uint8_t> bytes, std::uint32_t before = 0);

}  // namespace striate
