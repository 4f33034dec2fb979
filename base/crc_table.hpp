#pragma once

#include <array>
#include <cstdint>

namespace striate {

/// What each byte makes of a reflected 32-bit CRC. @param polynomial reflected, too:
/// 0x82F63B78 for CRC-32C, 0xEDB88320 for the CRC-32 of ISO 3309.
[[nodiscard]] constexpr std::array<std::uint32_t, 256> reflected_crc_table(
    std::uint32_t polynomial) {
  std::array<std::uint32_t, 256> table{};
  for (std::uint32_t byte = 0; byte < table.size(); ++byte) {
    std::uint32_t value = byte;
    for (int bit = 0; bit < 8; ++bit) value = (value >> 1) ^ ((value & 1) != 0 ? polynomial : 0U);
    table[byte] = value;
  }
  return table;
}

}  // namespace striate
