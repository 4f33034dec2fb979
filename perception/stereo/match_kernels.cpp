#define HWY_WANT_AVX3_DL 1

#include "striate/perception/stereo/match_kernels.hpp"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "striate/perception/stereo/match_kernels.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h, which defines the target.
#include <hwy/highway.h>

#include "striate/perception/stereo/match_tables-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace striate::perception::stereo_kernels::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// What is summed up at a time, blocks x disparities, fits into the registers: 32 or 16 of them.
#if HWY_TARGET == HWY_SCALAR
constexpr int kBlocks = 1;  // scalar: nothing to gain from blocks
constexpr int kDepth = 1;   // scalar: one shift after the other
#elif HWY_TARGET <= HWY_AVX3
constexpr int kBlocks = 3;  // with 8 shifts 24 sums: 32 registers hold them and the rows
constexpr int kDepth = 8;   // shifts; with 3 blocks 24 sums
#else
constexpr int kBlocks = 2;  // with 4 shifts 8 sums: 16 registers hold them and the rows
constexpr int kDepth = 4;   // shifts; with 2 blocks 8 sums
#endif

/// kCount blocks of left pixels against kDepth shifts of the right row. One load of the right row
/// at u serves them all: block b, at x + b * lanes, sees it at disparity x + b * lanes - u.
/// @param x of the first block.
/// @param u of the right row; shifts u, u - 1, ... are tried.
template <int kCount, class D>
HWY_INLINE void MatchTile(D d8, const MatchRow& row, int x, int u) {
  const int step = static_cast<int>(hn::Lanes(d8));
  hn::Vec<D> sums[kCount][kDepth];
#pragma GCC unroll 8
  for (int j = 0; j < kDepth; ++j) {
#pragma GCC unroll 4
    for (int b = 0; b < kCount; ++b) sums[b][j] = hn::Zero(d8);
  }
  const std::uint8_t* HWY_RESTRICT left = row.left.data + x;
  const std::uint8_t* HWY_RESTRICT right = row.right.data + u;
  for (int p = 0; p < kDescriptorPoints; ++p) {
    hn::Vec<D> here[kCount];
#pragma GCC unroll 4
    for (int b = 0; b < kCount; ++b) here[b] = hn::LoadU(d8, left + b * step);
#pragma GCC unroll 8
    for (int j = 0; j < kDepth; ++j) {
      const hn::Vec<D> there = hn::LoadU(d8, right - j);
#pragma GCC unroll 4
      for (int b = 0; b < kCount; ++b) {
        sums[b][j] = hn::SaturatedAdd(sums[b][j], hn::PopulationCount(hn::Xor(here[b], there)));
      }
    }
    left += row.left.stride;
    right += row.right.stride;
  }
#pragma GCC unroll 4
  for (int b = 0; b < kCount; ++b) {
    const int at = x + b * step;
    hn::Vec<D> smallest = hn::LoadU(d8, row.smallest + at);
    hn::Vec<D> best = hn::LoadU(d8, row.best + at);
#pragma GCC unroll 8
    for (int j = 0; j < kDepth; ++j) {
      const int disparity = at - u + j;
      if (disparity >= row.candidates) break;
      // A cost of 255 beside the image never wins: smallest begins with 255.
      const auto cost = hn::Or(sums[b][j], hn::LoadU(d8, row.outside + u - j));
      // cost >= smallest: no unsigned comparison needed.
      const auto not_smaller = hn::Eq(hn::Max(cost, smallest), cost);
      best = hn::IfThenElse(not_smaller, best, hn::Set(d8, static_cast<std::uint8_t>(disparity)));
      smallest = hn::Min(smallest, cost);
    }
    hn::StoreU(smallest, d8, row.smallest + at);
    hn::StoreU(best, d8, row.best + at);
  }
}

/// Left pixels from `begin` to `end`, both multiples of a block. Every block sees its disparities
/// in ascending order, so that of equal ones the smallest wins.
template <class D>
HWY_INLINE void MatchBlocks(D d8, const MatchRow& row, int begin, int end) {
  const int step = static_cast<int>(hn::Lanes(d8));
  for (int group = end - step; group >= 0; group -= step) {
    const int first = std::max(begin, group);
    const int depth = std::min(step, row.candidates - (first - group));
    for (int j = 0; j < depth; j += kDepth) {
      const int u = group - j;
      int x = first;
      auto room_for = [&](int blocks) {
        const int last = x + (blocks - 1) * step;
        return last < end && last - u < row.candidates;
      };
      for (; room_for(kBlocks); x += kBlocks * step) MatchTile<kBlocks>(d8, row, x, u);
      if constexpr (kBlocks > 2) {
        for (; room_for(2); x += 2 * step) MatchTile<2>(d8, row, x, u);
      }
      for (; room_for(1); x += step) MatchTile<1>(d8, row, x, u);
    }
  }
}

void BestMatchesByCounting(const MatchRow& row) {
  const hn::ScalableTag<std::uint8_t> d8;
  const int step = static_cast<int>(hn::Lanes(d8));
  std::fill(row.smallest, row.smallest + row.width, std::uint8_t{255});
  std::fill(row.best, row.best + row.width, std::uint8_t{0});
  const int whole = row.width / step * step;
  MatchBlocks(d8, row, 0, whole);
  if (whole == row.width) return;
#if HWY_TARGET != HWY_SCALAR
  if (row.width - whole <= step / 2) {
    MatchBlocks(hn::Half<decltype(d8)>(), row, whole, whole + step / 2);
    return;
  }
#endif
  MatchBlocks(d8, row, whole, whole + step);
}

void BestMatches(const MatchRow& row) {
#if STRIATE_MATCH_BY_TABLES
  BestMatchesByTables(row);
#else
  BestMatchesByCounting(row);
#endif
}

}  // namespace striate::perception::stereo_kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace striate::perception::stereo_kernels {

HWY_EXPORT(BestMatches);

void best_matches(const MatchRow& row) {
  HWY_DYNAMIC_DISPATCH(BestMatches)(row);
}

}  // namespace striate::perception::stereo_kernels
#endif
