#pragma once

#include <SQLiteCpp/Column.h>

#include <cstdint>
#include <span>
#include <vector>

#include "striate/base/crc32c.hpp"
#include "striate/memory/long_term/records.hpp"
#include "striate/perception/percept.hpp"

/// How a view becomes bytes: descriptors 32 bytes each, keypoints four little-endian floats each.
namespace striate::memory {

/// The bytes of a column; valid until the statement steps on.
[[nodiscard]] std::span<const std::uint8_t> bytes_of(const SQLite::Column& column);

[[nodiscard]] std::span<const std::uint8_t> bytes_of(const std::vector<StoredDescriptor>& all);
[[nodiscard]] std::span<const std::uint8_t> bytes_of(
    const std::vector<perception::ViewKeypoint>& all);

/// @param bytes a whole number of elements, as the tables' CHECK ensures; a rest is left out.
void unpack(std::span<const std::uint8_t> bytes, std::vector<StoredDescriptor>& all);
void unpack(std::span<const std::uint8_t> bytes, std::vector<perception::ViewKeypoint>& all);

/// Over everything that recognition rests on: size, descriptors, keypoints.
[[nodiscard]] std::uint32_t checksum_of_view(double width_px, double height_px,
                                             std::span<const std::uint8_t> descriptors,
                                             std::span<const std::uint8_t> keypoints);

[[nodiscard]] StoredDescriptor stored(const perception::Descriptor& descriptor);
[[nodiscard]] perception::Descriptor descriptor_of(const StoredDescriptor& stored);

}  // namespace striate::memory
