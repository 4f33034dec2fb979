#define HWY_WANT_AVX3_DL 1

#include "striate/perception/stereo/phase_costs.hpp"

#include <array>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "striate/perception/stereo/phase_costs.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h, which defines the target.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace striate::perception::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// distances[d * stride + x] for x from -kPhaseReach to width + kPhaseReach.
void CodeDistances(const std::array<const std::uint8_t*, kPhaseBytes>& left,
                   const std::array<const std::uint8_t*, kPhaseBytes>& right, int width,
                   int disparities, std::uint8_t* HWY_RESTRICT distances, int stride) {
  const hn::ScalableTag<std::uint8_t> d8;
  const int step = static_cast<int>(hn::Lanes(d8));
  for (int x = -kPhaseReach; x < width + kPhaseReach; x += step) {
    const auto left0 = hn::LoadU(d8, left[0] + x), left1 = hn::LoadU(d8, left[1] + x);
    const auto left2 = hn::LoadU(d8, left[2] + x), left3 = hn::LoadU(d8, left[3] + x);
    for (int d = 0; d < disparities; ++d) {
      const int from = x - d;
      const auto bits0 = hn::PopulationCount(hn::Xor(left0, hn::LoadU(d8, right[0] + from)));
      const auto bits1 = hn::PopulationCount(hn::Xor(left1, hn::LoadU(d8, right[1] + from)));
      const auto bits2 = hn::PopulationCount(hn::Xor(left2, hn::LoadU(d8, right[2] + from)));
      const auto bits3 = hn::PopulationCount(hn::Xor(left3, hn::LoadU(d8, right[3] + from)));
      hn::StoreU(hn::Add(hn::Add(bits0, bits1), hn::Add(bits2, bits3)), d8,
                 distances + d * stride + x);
    }
  }
}

/// costs = sum of the distances at kPhasePoints; lines[2 + dv] is the line dv rows below.
void SumOverPoints(const std::array<const std::uint8_t*, 2 * kPhaseReach + 1>& lines,
                   const std::uint8_t* HWY_RESTRICT outside, int width, int disparities,
                   std::uint8_t* HWY_RESTRICT costs, int stride) {
  const hn::ScalableTag<std::uint8_t> d8;
  const int step = static_cast<int>(hn::Lanes(d8));
  for (int d = 0; d < disparities; ++d) {
    for (int x = 0; x < width; x += step) {
      auto sum = hn::LoadU(d8, outside + x - d);
      for (const DescriptorPoint& point : kPhasePoints) {
        const std::uint8_t* line = lines[static_cast<std::size_t>(kPhaseReach + point.dv)];
        sum = hn::SaturatedAdd(sum, hn::LoadU(d8, line + d * stride + x + point.du));
      }
      hn::StoreU(sum, d8, costs + d * stride + x);
    }
  }
}

}  // namespace striate::perception::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace striate::perception {

HWY_EXPORT(CodeDistances);
HWY_EXPORT(SumOverPoints);

namespace {
/// Rows of distances that the points of a descriptor reach
constexpr int kLines = 2 * kPhaseReach + 1;
int in_ring(int y) {
  return (y + kLines) % kLines;
}
}  // namespace

void PhaseCosts::compare_codes(const Job& job, int y) {
  std::array<const std::uint8_t*, kPhaseBytes> left{}, right{};
  for (std::size_t k = 0; k < kPhaseBytes; ++k) {
    left[k] = job.left.bytes[k].row(y);
    right[k] = job.right.bytes[k].row(y);
  }
  HWY_DYNAMIC_DISPATCH(CodeDistances)
  (left, right, job.left.width, job.costs.disparities, code_distances_.line(in_ring(y)),
   job.costs.stride());
}

void PhaseCosts::compute_row(const Job& job, int y) {
  const int disparities = job.costs.disparities;
  if (y == 0) {
    code_distances_.resize(kLines, disparities, job.left.width);
    for (int above = -kPhaseReach; above < kPhaseReach; ++above) compare_codes(job, above);
  }
  compare_codes(job, y + kPhaseReach);
  std::array<const std::uint8_t*, kLines> lines{};
  for (int k = 0; k < kLines; ++k) {
    lines[static_cast<std::size_t>(k)] = code_distances_.line(in_ring(y - kPhaseReach + k));
  }
  HWY_DYNAMIC_DISPATCH(SumOverPoints)
  (lines, job.outside.row(0), job.left.width, disparities, job.costs.line(y), job.costs.stride());
}

}  // namespace striate::perception
#endif
