#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/bytes.hpp"
#include "platform/replay/recording.hpp"

/// The payloads of a recording's chunks, bit for bit; pictures as PNG, which loses nothing.
namespace striate::replay {

[[nodiscard]] std::vector<std::uint8_t> encode(const RecordedSetup& setup);
/// @throws BadBytes
[[nodiscard]] RecordedSetup decode_setup(std::span<const std::uint8_t> payload);

/// @param same_pictures the pictures are those of the cycle that was encoded before, and are not
/// written again.
/// @param payload gets the bytes; its room is used again.
void encode(const RecordedCycle& cycle, bool same_pictures, std::vector<std::uint8_t>& payload);
/// @param cycle the one that was decoded before, which keeps pictures that were not written again
/// @throws BadBytes; `cycle` is then of no use
void decode_cycle(std::span<const std::uint8_t> payload, RecordedCycle& cycle);

}  // namespace striate::replay
