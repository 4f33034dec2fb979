#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "striate/base/bytes.hpp"
#include "striate/platform/replay/recording.hpp"

/// The payloads of a recording's chunks, bit for bit; images as PNG, which loses nothing.
namespace striate::replay {

[[nodiscard]] std::vector<std::uint8_t> encode(const RecordedSetup& setup);
/// @throws BadBytes
[[nodiscard]] RecordedSetup decode_setup(std::span<const std::uint8_t> payload);

/// @param same_images the images are those of the cycle that was encoded before, and are not
/// written again.
/// @param payload gets the bytes; its room is used again.
void encode(const RecordedCycle& cycle, bool same_images, std::vector<std::uint8_t>& payload);
/// @param cycle the one that was decoded before, which keeps images that were not written again
/// @throws BadBytes; `cycle` is then of no use
void decode_cycle(std::span<const std::uint8_t> payload, RecordedCycle& cycle);

}  // namespace striate::replay
