#pragma once

#include <cstdint>
#include <string_view>

#include "striate/base/bytes.hpp"

namespace striate::viewer::mcap {

/// How the chunks of a file are made smaller.
enum class Compression : std::uint8_t { none, zstd, lz4 };

/// "", "zstd", "lz4": as it stands in a chunk.
[[nodiscard]] std::string_view name_in_file(Compression compression);
/// "none", "zstd", "lz4": as a person writes it. @throws std::invalid_argument for another word
[[nodiscard]] Compression compression_of(std::string_view word);

/// @throws std::runtime_error where the library cannot
[[nodiscard]] Bytes compress(ByteView bytes, Compression compression);

/// @param name as in a chunk. @param size of what comes out; more is never made
/// @throws BadBytes for an unknown name, damaged bytes, or another size
void decompress(ByteView bytes, std::string_view name, std::uint64_t size, Bytes& to);

}  // namespace striate::viewer::mcap
