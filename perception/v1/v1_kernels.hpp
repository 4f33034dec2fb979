#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "striate/perception/v1/filter_bank.hpp"
#include "striate/perception/v1/plane.hpp"

/// The vector code of V1Cells, dispatched at run time. Integer throughout: the same bits on every
/// instruction set. Two neighbouring 16-bit values are kept as one 32-bit element (first one in
/// the low half), so that one multiply-add instruction serves two taps.
namespace striate::perception::v1_kernels {

/// A image row folded about every pixel, for filters that are even or odd: row k holds pairs
///   even: (s_2k, s_2k+1)     s_0 = grey[x], s_k = grey[x + k] + grey[x - k]
///   odd:  (d_2k+1, d_2k+2)   d_k = grey[x + k] - grey[x - k]
/// which halves the work of every row filter and is done once for all of them.
struct FoldedRow {
  std::int32_t* even = nullptr;
  std::int32_t* odd = nullptr;
  int stride = 0;
};

[[nodiscard]] constexpr int even_pairs(int radius) {
  return radius / 2 + 1;
}
[[nodiscard]] constexpr int odd_pairs(int radius) {
  return (radius + 1) / 2;
}

/// @param grey 16 (grey - 128), readable from -(radius + 1) to width + radius + 1.
void fold_row(const std::int16_t* grey, int radius, int width, const FoldedRow& out);

/// The right half of an even or odd row filter, as pairs that fit FoldedRow.
struct RowTaps {
  bool even = true;
  std::vector<std::int32_t> pairs;
};

/// Two image rows through one row filter: out[x] = (row a, row b), 16 bits each, rounded.
void filter_rows(const FoldedRow& a, const FoldedRow& b, const RowTaps& taps, int width,
                 std::int32_t* out);

/// Output rows that are filtered at a time: both need the same input.
inline constexpr int kRowsAtOnce = 2;

/// A product's filtered rows and its column taps, in pairs, for each of the output rows.
struct ColumnInput {
  const std::int32_t* rows = nullptr;
  std::array<const std::int32_t*, kRowsAtOnce> even_taps{};
  std::array<const std::int32_t*, kRowsAtOnce> odd_taps{};
};

/// Where the responses of one orientation go; null: not wanted.
struct Responses {
  std::int16_t* code = nullptr;
  std::int16_t* even = nullptr;
  std::int16_t* odd = nullptr;
};

struct ColumnJob {
  std::array<std::vector<ColumnInput>, 2> slots;
  std::vector<std::ptrdiff_t> offsets;  ///< where the pairs of rows lie, from ColumnInput::rows
  int rows = 0;                         ///< output rows, 1 or 2
  bool odd_only = false;                ///< even taps are not looked at, only `odd` is written
  /// Sums over the support, of 16 (grey - 128); may be null.
  std::array<const std::int32_t*, kRowsAtOnce> box{};
  std::int32_t box_factor = 0;
  std::int32_t offset = 0;
  std::array<Responses, kRowsAtOnce> direct;    ///< of theta
  std::array<Responses, kRowsAtOnce> mirrored;  ///< of pi - theta; odd and code null: no such one
};

/// One or two output rows of an orientation pair.
void filter_columns(const ColumnJob& job, int width);

/// box[x] += add[x] - subtract[x], 32 bit; the moving window of a box filter.
void slide_box(const std::int32_t* add, const std::int32_t* subtract, int width, std::int32_t* box);

}  // namespace striate::perception::v1_kernels
