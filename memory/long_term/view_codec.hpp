#pragma once

#include <SQLiteCpp/Column.h>

#include <cstdint>
#include <span>
#include <vector>

#include "base/crc32c.hpp"
#include "memory/long_term/records.hpp"
#include "perception/percept.hpp"

/// How a view becomes bytes: descriptors 32 bytes each, keypoints four little-endian floats each.
namespace striate {

/// The bytes of a column; valid until the statement steps on.
[[nodiscard]] std::span<const std::uint8_t> bytes_of(const SQLite::Column& column);

[[nodiscard]] std::span<const std::uint8_t> bytes_of(const std::vector<StoredDescriptor>& all);
[[nodiscard]] std::span<const std::uint8_t> bytes_of(const std::vector<ViewKeypoint>& all);

/// @param bytes a whole number of elements, as the tables' CHECK ensures; a rest is left out.
void unpack(std::span<const std::uint8_t> bytes, std::vector<StoredDescriptor>& all);
void unpack(std::span<const std::uint8_t> bytes, std::vector<ViewKeypoint>& all);

/// Over everything that recognition rests on: size, descriptors, keypoints.
[[nodiscard]] std::uint32_t checksum_of_view(double width_px, double height_px,
                                             std::span<const std::uint8_t> descriptors,
                                             std::span<const std::uint8_t> keypoints);

[[nodiscard]] StoredDescriptor stored(const Descriptor& descriptor);
[[nodiscard]] Descriptor descriptor_of(const StoredDescriptor& stored);

}  // namespace striate
