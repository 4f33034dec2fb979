#define HWY_WANT_AVX3_DL 1

#include "perception/stereo/cost_kernels.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "perception/stereo/cost_kernels.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h, which defines the target.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace striate::stereo_kernels::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

void HammingCosts(const DescriptorRow& left, const DescriptorRow& right,
                  const std::uint8_t* HWY_RESTRICT outside, int width, int candidates,
                  std::uint8_t* HWY_RESTRICT costs, int cost_stride) {
  const hn::ScalableTag<std::uint8_t> d8;
  const int step = static_cast<int>(hn::Lanes(d8));
  for (int x = 0; x < width; x += step) {
    for (int d = 0; d < candidates; d += 4) {
      auto sum0 = hn::Zero(d8), sum1 = hn::Zero(d8), sum2 = hn::Zero(d8), sum3 = hn::Zero(d8);
      const std::uint8_t* HWY_RESTRICT from_left = left.data + x;
      const std::uint8_t* HWY_RESTRICT from_right = right.data + x - d;
      for (int p = 0; p < kDescriptorPoints; ++p) {
        const auto here = hn::LoadU(d8, from_left);
        auto differing = [&](int back) HWY_ATTR {
          return hn::PopulationCount(hn::Xor(here, hn::LoadU(d8, from_right - back)));
        };
        sum0 = hn::SaturatedAdd(sum0, differing(0));
        sum1 = hn::SaturatedAdd(sum1, differing(1));
        sum2 = hn::SaturatedAdd(sum2, differing(2));
        sum3 = hn::SaturatedAdd(sum3, differing(3));
        from_left += left.stride;
        from_right += right.stride;
      }
      std::uint8_t* to = costs + d * cost_stride + x;
      const std::uint8_t* mask = outside + x - d;
      hn::StoreU(hn::Or(sum0, hn::LoadU(d8, mask)), d8, to);
      hn::StoreU(hn::Or(sum1, hn::LoadU(d8, mask - 1)), d8, to + cost_stride);
      hn::StoreU(hn::Or(sum2, hn::LoadU(d8, mask - 2)), d8, to + 2 * cost_stride);
      hn::StoreU(hn::Or(sum3, hn::LoadU(d8, mask - 3)), d8, to + 3 * cost_stride);
    }
  }
}

void SmallestCost(const std::uint8_t* HWY_RESTRICT costs, int cost_stride, int width,
                  int candidates, std::uint8_t* HWY_RESTRICT best) {
  const hn::ScalableTag<std::uint8_t> d8;
  const int step = static_cast<int>(hn::Lanes(d8));
  for (int x = 0; x < width; x += step) {
    auto smallest = hn::LoadU(d8, costs + x);
    auto at = hn::Zero(d8);
    for (int d = 1; d < candidates; ++d) {
      const auto cost = hn::LoadU(d8, costs + d * cost_stride + x);
      // cost >= smallest: no unsigned comparison needed.
      const auto not_smaller = hn::Eq(hn::Max(cost, smallest), cost);
      at = hn::IfThenElse(not_smaller, at, hn::Set(d8, static_cast<std::uint8_t>(d)));
      smallest = hn::Min(smallest, cost);
    }
    hn::StoreU(at, d8, best + x);
  }
}

}  // namespace striate::stereo_kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace striate::stereo_kernels {

HWY_EXPORT(HammingCosts);
HWY_EXPORT(SmallestCost);

void hamming_costs(const DescriptorRow& left, const DescriptorRow& right,
                   const std::uint8_t* outside, int width, int candidates, std::uint8_t* costs,
                   int cost_stride) {
  HWY_DYNAMIC_DISPATCH(HammingCosts)
  (left, right, outside, width, candidates, costs, cost_stride);
}

void smallest_cost(const std::uint8_t* costs, int cost_stride, int width, int candidates,
                   std::uint8_t* best) {
  HWY_DYNAMIC_DISPATCH(SmallestCost)(costs, cost_stride, width, candidates, best);
}

}  // namespace striate::stereo_kernels
#endif
