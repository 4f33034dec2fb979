#define HWY_WANT_AVX3_DL 1

#include "striate/perception/stereo/winner_kernels.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "striate/perception/stereo/winner_kernels.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h, which defines the target.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace striate::perception::stereo_kernels::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using D16 = hn::ScalableTag<std::uint16_t>;
using V16 = hn::Vec<D16>;

HWY_INLINE V16 Number(int value) {
  return hn::Set(D16(), static_cast<std::uint16_t>(value));
}

/// Keeps the smaller of `value` and `smallest`, and its disparity; of equal ones the earlier.
HWY_INLINE void Keep(V16 value, V16 disparity, V16& smallest, V16& best) {
  const auto not_smaller = hn::Eq(hn::Max(value, smallest), value);
  best = hn::IfThenElse(not_smaller, best, disparity);
  smallest = hn::Min(value, smallest);
}

/// Sums of all paths, and the left image's winners.
void LeftWinners(const SmoothedRow& from, const WinnerRow& to) {
  const D16 d16;
  const hn::Rebind<std::uint8_t, D16> d8;
  const int step = static_cast<int>(hn::Lanes(d16));
  for (int x = 0; x < from.width; x += step) {
    V16 smallest = Number(65535), best = hn::Zero(d16);
    for (int d = 0; d < from.disparities; ++d) {
      const V16 steep = hn::LoadU(d16, from.steep_sums + d * from.sum_stride + x);
      const V16 level =
          hn::PromoteTo(d16, hn::LoadU(d8, from.level_means + d * from.mean_stride + x));
      const V16 outside = hn::PromoteTo(d16, hn::LoadU(d8, from.outside + x - d));
      const V16 sum =
          hn::Or(hn::Add(steep, hn::Add(level, level)), hn::Or(outside, hn::ShiftLeft<8>(outside)));
      hn::StoreU(sum, d16, to.sums + d * to.stride + x);
      Keep(sum, Number(d), smallest, best);
    }
    hn::StoreU(best, d16, to.best + x);
    hn::StoreU(smallest, d16, to.smallest + x);
  }
  for (int d = 0; d < from.disparities; ++d) {
    for (int x = from.width; x < (from.width + step - 1) / step * step; ++x) {
      to.sums[d * to.stride + x] = 65535;
    }
  }
}

void RunnersUp(const SmoothedRow& from, const WinnerRow& to) {
  const D16 d16;
  const hn::Rebind<std::uint8_t, D16> d8;
  const int step = static_cast<int>(hn::Lanes(d16));
  for (int x = 0; x < from.width; x += step) {
    const V16 before = hn::Sub(hn::LoadU(d16, to.best + x), Number(1));
    V16 second = Number(65535), raw_second = Number(255);
    for (int d = 0; d < from.disparities; ++d) {
      const V16 sum = hn::LoadU(d16, to.sums + d * to.stride + x);
      // d - (best - 1) is 0, 1 or 2, modulo 2^16, at the winner and beside it.
      const V16 apart = hn::Sub(Number(d), before);
      const auto beside = hn::Eq(hn::Min(apart, Number(2)), apart);
      second = hn::Min(second, hn::IfThenElse(beside, Number(65535), sum));
      const V16 cost = hn::PromoteTo(d16, hn::LoadU(d8, from.costs + d * from.mean_stride + x));
      raw_second = hn::Min(raw_second, hn::IfThenElse(beside, Number(255), cost));
    }
    hn::StoreU(raw_second, d16, to.raw_second + x);
    hn::StoreU(second, d16, to.second + x);
  }
}

void RightWinners(const SmoothedRow& from, const WinnerRow& to) {
  const D16 d16;
  const int step = static_cast<int>(hn::Lanes(d16));
  for (int x = 0; x < from.width; x += step) {
    V16 smallest = Number(65535), best = hn::Zero(d16);
    for (int d = 0; d < from.disparities; ++d) {
      Keep(hn::LoadU(d16, to.sums + d * to.stride + x + d), Number(d), smallest, best);
    }
    hn::StoreU(best, d16, to.right_best + x);
  }
}

void FindWinners(const SmoothedRow& from, const WinnerRow& to) {
  LeftWinners(from, to);
  RunnersUp(from, to);
  RightWinners(from, to);
}

void LargestOfRows(const std::array<const std::int16_t*, 8>& rows, int width,
                   std::int16_t* HWY_RESTRICT largest) {
  const hn::ScalableTag<std::int16_t> d16;
  const int step = static_cast<int>(hn::Lanes(d16));
  for (int x = 0; x < width; x += step) {
    auto most = hn::LoadU(d16, rows[0] + x);
    for (std::size_t k = 1; k < rows.size(); ++k) most = hn::Max(most, hn::LoadU(d16, rows[k] + x));
    hn::StoreU(most, d16, largest + x);
  }
}

}  // namespace striate::perception::stereo_kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace striate::perception::stereo_kernels {

HWY_EXPORT(FindWinners);
HWY_EXPORT(LargestOfRows);

void find_winners(const SmoothedRow& from, const WinnerRow& to) {
  HWY_DYNAMIC_DISPATCH(FindWinners)(from, to);
}

void largest_of_rows(const std::array<const std::int16_t*, 8>& rows, int width,
                     std::int16_t* largest) {
  HWY_DYNAMIC_DISPATCH(LargestOfRows)(rows, width, largest);
}

}  // namespace striate::perception::stereo_kernels
#endif
