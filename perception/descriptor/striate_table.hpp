#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace striate::perception {

/// 1 + 6 + 8 + 10 on the circles of striate_descriptor.cpp
inline constexpr int kPooledPoints = 25;
inline constexpr int kPooledChannels = 16;  ///< odd cells: 8 orientations, light and dark side
/// 400 numbers a patch: 79,800 comparisons to choose 256 from
inline constexpr int kPooledValues = kPooledPoints * kPooledChannels;

/// One bit: pooled response `first` is larger than `second` by more than `threshold` thousandths of
/// the patch's mean response. A pooled response's number is point * 16 + channel.
struct StriateBit {
  int first = 0;
  int second = 0;
  int threshold = 0;
};

using StriateTable = std::array<StriateBit, 256>;

/// Reads 256 lines "first second threshold"; lines that begin with # are comments.
/// @throws UserError with name:line where one is wrong.
[[nodiscard]] StriateTable parse_striate_table(const std::string& text, const std::string& name);

/// The table that ships: learned on made images by `striate learn-descriptor`.
[[nodiscard]] const StriateTable& shipped_striate_table();

/// As parse_striate_table() reads it. @param header comment lines, each beginning with #.
[[nodiscard]] std::string striate_table_text(const std::vector<StriateBit>& bits,
                                             const std::string& header);

}  // namespace striate::perception
