#pragma once

#include <algorithm>
#include <vector>

#include "striate/perception/descriptor/pooling_kernels.hpp"

/// What perception/descriptor/pooling_kernels.hpp promises, in plain loops.
namespace striate::reference {

/// a b / 32768 to the nearest whole number, halves upwards.
inline int times_15(int a, int b) {
  return (a * b + (1 << 14)) >> 15;
}

/// Zero in the rows that are left out.
inline std::vector<std::int16_t> turned_window(const perception::pooling_kernels::OddWindow& window,
                                               const perception::pooling_kernels::Turn& turn) {
  using namespace perception::pooling_kernels;
  std::vector<std::int16_t> out(kFirstTurned_px * kWindowSide_px * kChannels);
  for (int y = kFirstTurned_px; y < kBehindTurned_px; ++y) {
    for (int x = 0; x < kWindowSide_px; ++x) {
      auto towards = [&](int direction) {
        const int d = direction % kChannels;
        const int odd = window.odd[static_cast<std::size_t>(d % perception::kOrientations)]
                                  [static_cast<std::ptrdiff_t>(y) * window.stride + x];
        return (d < perception::kOrientations ? odd : -odd) * turn.factor;
      };
      for (int c = 0; c < kChannels; ++c) {
        const int here = towards(turn.steps + c % perception::kOrientations);
        const int next = towards(turn.steps + c % perception::kOrientations + 1);
        const int between = here - times_15(here, turn.fraction) + times_15(next, turn.fraction);
        out.push_back(static_cast<std::int16_t>(
            std::max(c < perception::kOrientations ? between : -between, 0)));
      }
    }
  }
  out.resize(kWindowValues);
  return out;
}

inline std::int16_t pooled(const std::vector<std::int16_t>& window,
                           const perception::pooling_kernels::Pool& pool, int channel) {
  using namespace perception::pooling_kernels;
  int sum = 0;
  for (int y = 0; y < pool.height; ++y) {
    int along = 0;
    for (int x = 0; x < pool.width; ++x) {
      const int pixel = pool.first_pixel + y * kWindowSide_px + x;
      along +=
          times_15(window[static_cast<std::size_t>(pixel * kChannels + channel)], pool.across[x]);
    }
    sum += times_15(along, pool.down[y]);
  }
  return static_cast<std::int16_t>(sum);
}

}  // namespace striate::reference
