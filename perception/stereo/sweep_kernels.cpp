#define HWY_WANT_AVX3_DL 1

#include "perception/stereo/sweep_kernels.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "perception/stereo/sweep_kernels.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h, which defines the target.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace striate::stereo_kernels::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using D8 = hn::ScalableTag<std::uint8_t>;
using V8 = hn::Vec<D8>;

/// The window of three disparities that slides over one path direction at one position.
struct Path {
  const std::uint8_t* HWY_RESTRICT from;  ///< of the line before, already askew
  std::uint8_t* HWY_RESTRICT to;
  V8 below, at, floor, ceiling, smallest;

  HWY_INLINE void Start(const PathLine& before, const PathLine& here, int x, int askew,
                        V8 large_penalty) {
    const D8 d8;
    from = before.costs + x + askew;
    to = here.costs + x;
    floor = hn::LoadU(d8, before.smallest + x + askew);
    ceiling = hn::SaturatedAdd(floor, large_penalty);
    below = hn::Set(d8, 255);
    at = hn::LoadU(d8, from);
    smallest = hn::Set(d8, 255);
  }

  /// Path cost of the next disparity; `above` is the one after it in the line before.
  HWY_INLINE V8 Next(V8 cost, V8 above, V8 small_penalty) {
    const V8 step = hn::SaturatedAdd(hn::Min(below, above), small_penalty);
    const V8 best = hn::Min(hn::Min(at, step), ceiling);
    const V8 result = hn::SaturatedAdd(cost, hn::Sub(best, floor));
    smallest = hn::Min(smallest, result);
    below = at;
    at = above;
    return result;
  }
};

/// One half of the lanes of the results, as 16 bit, onto the sums.
template <int kPaths, class D16, class Half>
HWY_INLINE void AddHalf(D16 d16, const V8* results, Half half, bool first, std::uint16_t* sums) {
  auto sum = first ? hn::Zero(d16) : hn::LoadU(d16, sums);
  for (int k = 0; k < kPaths; ++k) sum = hn::Add(sum, hn::PromoteTo(d16, half(results[k])));
  hn::StoreU(sum, d16, sums);
}

template <int kPaths>
HWY_INLINE void AddToSums(const V8* results, std::uint16_t* sums, bool first) {
#if HWY_TARGET == HWY_SCALAR
  const hn::Rebind<std::uint16_t, D8> d16;
  AddHalf<kPaths>(
      d16, results, [](V8 v) HWY_ATTR { return v; }, first, sums);
#else
  const hn::Repartition<std::uint16_t, D8> d16;
  const hn::Half<D8> half8;
  AddHalf<kPaths>(
      d16, results, [=](V8 v) HWY_ATTR { return hn::LowerHalf(half8, v); }, first, sums);
  AddHalf<kPaths>(
      d16, results, [=](V8 v) HWY_ATTR { return hn::UpperHalf(half8, v); }, first,
      sums + hn::Lanes(d16));
#endif
}

/// Directions kFirst .. kFirst + kPaths - 1; direction k comes from x - 1 + k.
template <int kFirst, int kPaths>
HWY_INLINE void Sweep(const SweepStep& s) {
  const D8 d8;
  const V8 small_penalty = hn::Set(d8, static_cast<std::uint8_t>(s.small_penalty));
  const V8 large_penalty = hn::Set(d8, static_cast<std::uint8_t>(s.large_penalty));
  const int step = static_cast<int>(hn::Lanes(d8));
  for (int x = 0; x < s.width; x += step) {
    Path paths[kPaths];
    V8 results[kPaths];
    for (int k = 0; k < kPaths; ++k) {
      const auto direction = static_cast<std::size_t>(kFirst + k);
      paths[k].Start(s.before[direction], s.here[direction], x, kFirst + k - 1, large_penalty);
    }
    for (int d = 0; d < s.disparities; ++d) {
      const V8 cost = hn::LoadU(d8, s.costs + d * s.stride + x);
      const bool last = d + 1 == s.disparities;
      for (int k = 0; k < kPaths; ++k) {
        const V8 above =
            last ? hn::Set(d8, 255) : hn::LoadU(d8, paths[k].from + (d + 1) * s.stride);
        results[k] = paths[k].Next(cost, above, small_penalty);
        hn::StoreU(results[k], d8, paths[k].to + d * s.stride);
      }
      AddToSums<kPaths>(results, s.sums + d * s.sum_stride + x, s.first);
    }
    for (int k = 0; k < kPaths; ++k) {
      hn::StoreU(paths[k].smallest, d8, s.here[static_cast<std::size_t>(kFirst + k)].smallest + x);
    }
  }
  // Behind the last position paths start anew.
  for (int k = kFirst; k < kFirst + kPaths; ++k) {
    const PathLine& here = s.here[static_cast<std::size_t>(k)];
    here.smallest[s.width] = 0;
    for (int d = 0; d < s.disparities; ++d) here.costs[d * s.stride + s.width] = 0;
  }
}

void SweepThree(const SweepStep& step) {
  Sweep<0, 3>(step);
}
void SweepStraight(const SweepStep& step) {
  Sweep<1, 1>(step);
}

}  // namespace striate::stereo_kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace striate::stereo_kernels {

HWY_EXPORT(SweepThree);
HWY_EXPORT(SweepStraight);

void sweep_three(const SweepStep& step) {
  HWY_DYNAMIC_DISPATCH(SweepThree)(step);
}
void sweep_straight(const SweepStep& step) {
  HWY_DYNAMIC_DISPATCH(SweepStraight)(step);
}

}  // namespace striate::stereo_kernels
#endif
