#define HWY_WANT_AVX3_DL 1

#include "striate/perception/descriptor/pooling_kernels.hpp"

#include <cstddef>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "striate/perception/descriptor/pooling_kernels.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h, which defines the target.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace striate::perception::pooling_kernels::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

std::int16_t LargestResponse(const OddWindow& window) {
  const hn::CappedTag<std::int16_t, 2 * kOrientations> d;
  constexpr std::size_t kStep = hn::MaxLanes(d);  // 16-bit lanes at a time
  auto largest = hn::Zero(d), least = hn::Zero(d);
  for (const std::int16_t* plane : window.odd) {
    for (int y = 0; y < kWindowSide_px; ++y, plane += window.stride) {
      for (std::size_t x = 0; x < kWindowSide_px; x += kStep) {
        // The last ones are looked at twice rather than what lies behind them.
        const auto value = hn::LoadU(d, plane + HWY_MIN(x, kWindowSide_px - kStep));
        largest = hn::Max(largest, value);
        least = hn::Min(least, value);
      }
    }
  }
  largest = hn::Max(largest, hn::SaturatedSub(hn::Zero(d), least));
  return hn::GetLane(hn::MaxOfLanes(d, largest));
}

/// The 9 neighbouring directions that a turned image's 8 lie between.
struct Directions {
  const std::int16_t* plane[kOrientations + 1];
  std::int16_t factor[kOrientations + 1];

  Directions(const OddWindow& window, const Turn& turn) {
    for (int i = 0; i <= kOrientations; ++i) {
      const int direction = (turn.steps + i) % kChannels;
      plane[i] = window.odd[static_cast<std::size_t>(direction % kOrientations)];
      // Half a turn further, light and dark have changed sides.
      const bool same = direction < kOrientations;
      factor[i] = static_cast<std::int16_t>(same ? turn.factor : -turn.factor);
    }
  }
};

#if HWY_TARGET == HWY_SCALAR
void TurnWindow(const OddWindow& window, const Turn& turn, std::int16_t* HWY_RESTRICT out) {
  const Directions from(window, turn);
  out += kFirstTurned_px * kWindowSide_px * kChannels;
  for (int y = kFirstTurned_px; y < kBehindTurned_px; ++y) {
    for (int x = 0; x < kWindowSide_px; ++x, out += kChannels) {
      const std::ptrdiff_t at = static_cast<std::ptrdiff_t>(y) * window.stride + x;
      for (int i = 0; i < kOrientations; ++i) {
        const int value = from.plane[i][at] * from.factor[i];
        const int next = from.plane[i + 1][at] * from.factor[i + 1];
        auto share = [&](int response) { return (response * turn.fraction + (1 << 14)) >> 15; };
        const int between = value - share(value) + share(next);
        out[i] = static_cast<std::int16_t>(between > 0 ? between : 0);
        out[i + kOrientations] = static_cast<std::int16_t>(between < 0 ? -between : 0);
      }
    }
  }
}
#else
/// Eight pixels, or twice eight side by side.
using D8 = hn::FixedTag<std::int16_t, kOrientations>;
using DMost = hn::CappedTag<std::int16_t, 2 * kOrientations>;

/// Rows become columns: afterwards rows[k] holds element k of all eight, in each half by itself.
template <class D, class V = hn::Vec<D> >
HWY_INLINE void Transpose(D d, V* HWY_RESTRICT rows) {
  // Three perfect shuffles of 64 elements.
#pragma GCC unroll 3
  for (int round = 0; round < 3; ++round) {
    V shuffled[kOrientations];
#pragma GCC unroll 4
    for (int i = 0; i < 4; ++i) {
      shuffled[2 * i] = hn::InterleaveLower(d, rows[i], rows[i + 4]);
      shuffled[2 * i + 1] = hn::InterleaveUpper(d, rows[i], rows[i + 4]);
    }
#pragma GCC unroll 8
    for (int i = 0; i < kOrientations; ++i) rows[i] = shuffled[i];
  }
}

/// All channels of pixel k, and of pixel k + 8 in the upper half.
template <class D, class V = hn::Vec<D> >
HWY_INLINE void StorePixel(D d, V row, int k, std::int16_t* HWY_RESTRICT out) {
  const V light = hn::Max(row, hn::Zero(d)), dark = hn::Max(hn::Sub(hn::Zero(d), row), hn::Zero(d));
  out += k * kChannels;
#if HWY_MAX_BYTES >= 32
  if constexpr (hn::MaxLanes(D()) == 2 * kOrientations) {
    hn::StoreU(hn::ConcatLowerLower(d, dark, light), d, out);
    hn::StoreU(hn::ConcatUpperUpper(d, dark, light), d, out + kOrientations * kChannels);
    return;
  }
#endif
  hn::StoreU(light, d, out);
  hn::StoreU(dark, d, out + kOrientations);
}

/// As many pixels as d has lanes.
template <class D, class V = hn::Vec<D> >
HWY_INLINE void TurnPixels(D d, const Directions& from, std::ptrdiff_t at, std::int16_t fraction,
                           std::int16_t* HWY_RESTRICT out) {
  const V share_of_next = hn::Set(d, fraction);
  V rows[kOrientations];
  V value = hn::Mul(hn::LoadU(d, from.plane[0] + at), hn::Set(d, from.factor[0]));
#pragma GCC unroll 8
  for (int i = 0; i < kOrientations; ++i) {
    const V next = hn::Mul(hn::LoadU(d, from.plane[i + 1] + at), hn::Set(d, from.factor[i + 1]));
    // Not the difference of both, which 16 bits may not hold.
    const V share = hn::Sub(value, hn::MulFixedPoint15(value, share_of_next));
    rows[i] = hn::Add(share, hn::MulFixedPoint15(next, share_of_next));
    value = next;
  }
  Transpose(d, rows);
#pragma GCC unroll 8
  for (int k = 0; k < kOrientations; ++k) StorePixel(d, rows[k], k, out);
}

void TurnWindow(const OddWindow& window, const Turn& turn, std::int16_t* HWY_RESTRICT out) {
  const Directions from(window, turn);
  // Pixels at a time, as many as there are lanes
  constexpr int kStep = static_cast<int>(hn::MaxLanes(DMost()));
  for (int y = kFirstTurned_px; y < kBehindTurned_px; ++y) {
    const std::ptrdiff_t at = static_cast<std::ptrdiff_t>(y) * window.stride;
    std::int16_t* to = out + y * kWindowSide_px * kChannels;
    int x = 0;
    for (; x + kStep <= kWindowSide_px; x += kStep) {
      TurnPixels(DMost(), from, at + x, turn.fraction, to + x * kChannels);
    }
    for (; x < kWindowSide_px; x += kOrientations) {
      TurnPixels(D8(), from, at + x, turn.fraction, to + x * kChannels);
    }
  }
}
#endif

void PoolAll(const std::int16_t* HWY_RESTRICT window, std::span<const Pool> pools,
             std::int16_t* HWY_RESTRICT out) {
  const hn::CappedTag<std::int16_t, kChannels> d;
  for (const Pool& p : pools) {
    for (std::size_t c = 0; c < kChannels; c += hn::Lanes(d)) {
      const std::int16_t* row = window + p.first_pixel * kChannels + c;
      auto sum = hn::Zero(d);
      for (int y = 0; y < p.height; ++y, row += kWindowSide_px * kChannels) {
        auto along = hn::Zero(d);
        for (int x = 0; x < p.width; ++x) {
          along = hn::SaturatedAdd(along, hn::MulFixedPoint15(hn::LoadU(d, row + x * kChannels),
                                                              hn::Set(d, p.across[x])));
        }
        sum = hn::SaturatedAdd(sum, hn::MulFixedPoint15(along, hn::Set(d, p.down[y])));
      }
      hn::StoreU(sum, d, out + c);
    }
    out += kChannels;
  }
}

}  // namespace striate::perception::pooling_kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace striate::perception::pooling_kernels {

HWY_EXPORT(LargestResponse);
HWY_EXPORT(TurnWindow);
HWY_EXPORT(PoolAll);

std::int16_t largest_response(const OddWindow& window) {
  return HWY_DYNAMIC_DISPATCH(LargestResponse)(window);
}

void turn_window(const OddWindow& window, const Turn& turn, std::int16_t* out) {
  HWY_DYNAMIC_DISPATCH(TurnWindow)(window, turn, out);
}

void pool(const std::int16_t* window, std::span<const Pool> pools, std::int16_t* out) {
  HWY_DYNAMIC_DISPATCH(PoolAll)(window, pools, out);
}

}  // namespace striate::perception::pooling_kernels
#endif
