#pragma once

#include <cstdint>
#include <span>

namespace striate {

/// The CRC-32 of ISO 3309, as in PNG, zip and MCAP: eight bytes a step.
/// @param before of the bytes that go before these; 0 for none
[[nodiscard]] std::uint32_t crc32(std::span<const std::uint8_t> bytes, std::uint32_t before = 0);

}  // namespace striate
