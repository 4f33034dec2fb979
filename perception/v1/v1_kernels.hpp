#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "perception/v1/filter_bank.hpp"
#include "perception/v1/plane.hpp"

/// The vector code of V1Cells, dispatched at run time. Integer throughout: the same bits on every
/// instruction set. Two neighbouring 16-bit values are kept as one 32-bit element (first one in
/// the low half), so that one multiply-add instruction serves two taps.
namespace striate::v1_kernels {

/// pairs[x] = (grey[x], grey[x + 1]) for x in [-radius, width + radius]; grey must be readable from
/// -radius to width + radius + 1.
void pair_up(const std::int16_t* grey, int radius, int width, std::int32_t* pairs);

/// Two picture rows through one row filter: out[x] = (row a, row b), 16 bits each, rounded.
/// `taps` are radius + 1 pairs.
void filter_rows(const std::int32_t* pairs_a, const std::int32_t* pairs_b,
                 const std::vector<std::int32_t>& taps, int width, std::int32_t* out);

/// A product's input rows for one output row and its column taps (radius + 1 pairs each).
struct ColumnInput {
  const std::int32_t* first = nullptr;  ///< next pair of rows lies `stride` further
  int stride = 0;
  const std::int32_t* even_taps = nullptr;
  const std::int32_t* odd_taps = nullptr;
};

/// Where the responses of one orientation go; even and odd may be null.
struct Responses {
  std::int16_t* code = nullptr;
  std::int16_t* even = nullptr;
  std::int16_t* odd = nullptr;
};

struct ColumnJob {
  std::array<std::vector<ColumnInput>, 2> slots;
  int taps = 0;                       ///< pairs in each column filter
  const std::int32_t* box = nullptr;  ///< sums over the support, of grey - 128; may be null
  std::int32_t box_factor = 0;
  std::int32_t offset = 0;
  Responses direct;    ///< of theta
  Responses mirrored;  ///< of pi - theta; code null: not wanted
};

/// One output row of an orientation pair.
void filter_columns(const ColumnJob& job, int width);

/// box[x] += add[x] - subtract[x], 32 bit; the moving window of a box filter.
void slide_box(const std::int32_t* add, const std::int32_t* subtract, int width, std::int32_t* box);

}  // namespace striate::v1_kernels
