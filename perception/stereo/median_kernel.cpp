#define HWY_WANT_AVX3_DL 1

#include "striate/perception/stereo/median_kernel.hpp"

#include <cstdint>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "striate/perception/stereo/median_kernel.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h, which defines the target.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace striate::perception::stereo_kernels::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using D8 = hn::ScalableTag<std::uint8_t>;
using V8 = hn::Vec<D8>;

HWY_INLINE void Order(V8& low, V8& high) {
  const V8 smaller = hn::Min(low, high);
  high = hn::Max(low, high);
  low = smaller;
}

/// The well-known network of 9 exchanges.
HWY_INLINE void Sort5(V8& a, V8& b, V8& c, V8& d, V8& e) {
  Order(a, b);
  Order(d, e);
  Order(c, e);
  Order(c, d);
  Order(b, e);
  Order(a, d);
  Order(a, c);
  Order(b, d);
  Order(b, c);
}

/// The smallest of n values to the front, the largest to the end.
template <int n>
HWY_INLINE void PartExtremes(V8* v) {
#pragma GCC unroll 4
  for (int k = 0; k < n / 2; ++k) Order(v[k], v[n - 1 - k]);
#pragma GCC unroll 4
  for (int k = 1; k < (n + 1) / 2; ++k) {
    Order(v[0], v[k]);
    Order(v[n - 1 - k], v[n - 1]);
  }
}

/// Of 13 values: of any 8 neither the smallest nor the largest is the median; without these two
/// take one more, and so on.
HWY_INLINE V8 MedianOf13(V8* v) {
  PartExtremes<8>(v);
  v[7] = v[8];
  PartExtremes<7>(v + 1);
  v[7] = v[9];
  PartExtremes<6>(v + 2);
  v[7] = v[10];
  PartExtremes<5>(v + 3);
  v[7] = v[11];
  PartExtremes<4>(v + 4);
  v[7] = v[12];
  PartExtremes<3>(v + 5);
  return v[6];
}

/// Columns are sorted, then rows. A value in row i, column j has (i + 1)(j + 1) values, itself
/// among them, that are not larger and (5 - i)(5 - j) that are not smaller; where one of these
/// exceeds 13 it is not the median. As many fall out below as above: 13 are left.
void MedianRow(const std::uint8_t* const* rows, int width, std::uint8_t* HWY_RESTRICT out) {
  const D8 d8;
  const int step = static_cast<int>(hn::Lanes(d8));
  for (int x = 0; x < width; x += step) {
    V8 v[5][5];
#pragma GCC unroll 5
    for (int u = 0; u < 5; ++u) {
      for (int r = 0; r < 5; ++r) v[r][u] = hn::LoadU(d8, rows[r] + x + u - 2);
      Sort5(v[0][u], v[1][u], v[2][u], v[3][u], v[4][u]);
    }
#pragma GCC unroll 5
    for (int r = 0; r < 5; ++r) Sort5(v[r][0], v[r][1], v[r][2], v[r][3], v[r][4]);
    V8 left[13] = {v[0][3], v[0][4], v[1][2], v[1][3], v[1][4], v[2][1], v[2][2],
                   v[2][3], v[3][0], v[3][1], v[3][2], v[4][0], v[4][1]};
    hn::StoreU(MedianOf13(left), d8, out + x);
  }
}

}  // namespace striate::perception::stereo_kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include <algorithm>

namespace striate::perception::stereo_kernels {

HWY_EXPORT(MedianRow);

void median_5x5(Plane<std::uint8_t>& values, Plane<std::uint8_t>& out) {
  const int width = values.width(), height = values.height();
  out.resize(width, height, 0, 0);
  for (int y = 0; y < height; ++y) {
    std::uint8_t* row = values.row(y);
    row[-2] = row[-1] = row[0];
    row[width] = row[width + 1] = row[width - 1];
  }
  for (int y = 0; y < height; ++y) {
    const std::uint8_t* rows[5];
    for (int k = 0; k < 5; ++k) rows[k] = values.row(std::clamp(y + k - 2, 0, height - 1));
    HWY_DYNAMIC_DISPATCH(MedianRow)(rows, width, out.row(y));
  }
}

}  // namespace striate::perception::stereo_kernels
#endif
