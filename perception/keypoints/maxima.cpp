#define HWY_WANT_AVX3_DL 1

#include "striate/perception/keypoints/maxima.hpp"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "striate/perception/keypoints/maxima.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h, which defines the target.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace striate::perception::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

std::uint16_t LargestInRow(const std::uint16_t* HWY_RESTRICT row, int width) {
  const hn::ScalableTag<std::uint16_t> d;
  const int step = static_cast<int>(hn::Lanes(d));
  std::uint16_t largest = 0;
  int x = 0;
  if (width >= step) {
    auto all = hn::Zero(d);
    for (; x + step <= width; x += step) all = hn::Max(all, hn::LoadU(d, row + x));
    HWY_ALIGN std::uint16_t lanes[HWY_MAX_BYTES / sizeof(std::uint16_t)];
    hn::Store(all, d, lanes);
    largest = *std::max_element(lanes, lanes + step);
  }
  for (; x < width; ++x) largest = std::max(largest, row[x]);
  return largest;
}

/// Columns from..to - 1 of one row.
void MaximaOfRow(const Plane<std::uint16_t>& plane, int y, int from, int to, std::uint16_t least,
                 std::vector<GridPoint>& out) {
  const hn::ScalableTag<std::uint16_t> d;
  const int step = static_cast<int>(hn::Lanes(d));
  const std::uint16_t* above = plane.row(y - 1);
  const std::uint16_t* row = plane.row(y);
  const std::uint16_t* below = plane.row(y + 1);
  const auto lowest = hn::Set(d, least);
  for (int x = from; x < to; x += step) {
    const auto here = hn::LoadU(d, row + x);
    auto beside = hn::Max(lowest, hn::LoadU(d, row + x - 1));
    beside = hn::Max(beside, hn::LoadU(d, row + x + 1));
    for (const std::uint16_t* other : {above, below}) {
      beside = hn::Max(beside, hn::LoadU(d, other + x - 1));
      beside = hn::Max(beside, hn::LoadU(d, other + x));
      beside = hn::Max(beside, hn::LoadU(d, other + x + 1));
    }
    const auto higher = hn::Gt(here, beside);
    if (hn::AllFalse(d, higher)) continue;
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(d, higher, bits);
    for (int k = 0; k < std::min(step, to - x); ++k) {
      if ((bits[k / 8] >> (k % 8) & 1) != 0) out.push_back({x + k, y, row[x + k]});
    }
  }
}

}  // namespace striate::perception::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace striate::perception {

HWY_EXPORT(LargestInRow);
HWY_EXPORT(MaximaOfRow);

std::uint16_t largest_value(const Plane<std::uint16_t>& plane) {
  std::uint16_t largest = 0;
  for (int y = 0; y < plane.height(); ++y) {
    largest = std::max(largest, HWY_DYNAMIC_DISPATCH(LargestInRow)(plane.row(y), plane.width()));
  }
  return largest;
}

void find_strict_maxima(const Plane<std::uint16_t>& plane, int border, std::uint16_t least,
                        std::vector<GridPoint>& out) {
  out.clear();
  for (int y = border; y < plane.height() - border; ++y) {
    HWY_DYNAMIC_DISPATCH(MaximaOfRow)(plane, y, border, plane.width() - border, least, out);
  }
}

}  // namespace striate::perception
#endif
