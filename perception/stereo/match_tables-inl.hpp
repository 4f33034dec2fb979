// Vector code, included once for every instruction set.
#if defined(STRIATE_STEREO_MATCH_TABLES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef STRIATE_STEREO_MATCH_TABLES_INL
#undef STRIATE_STEREO_MATCH_TABLES_INL
#else
#define STRIATE_STEREO_MATCH_TABLES_INL
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <cstddef>

#include "striate/perception/stereo/match_kernels.hpp"
#include "striate/perception/stereo/match_tables.hpp"

#undef STRIATE_MATCH_BY_TABLES
#if HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_SSE4 || HWY_TARGET == HWY_SSSE3
#define STRIATE_MATCH_BY_TABLES 1
#else
#define STRIATE_MATCH_BY_TABLES 0
#endif

#if STRIATE_MATCH_BY_TABLES
/// Matching for instruction sets that cannot count the bits of a vector's bytes. Half a byte of one
/// left pixel, a nibble, chooses the table of the bits in which it differs from every other nibble;
/// one shuffle looks a vector of right pixels up in it. So 4 bits of all lanes take a shuffle and
/// an addition, and no XOR. Lanes are disparities, not left pixels.
HWY_BEFORE_NAMESPACE();
namespace striate::perception::stereo_kernels::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

constexpr int kNibbles = 2 * kDescriptorPoints;  ///< half bytes a descriptor of 32 bytes
/// Vectors from one block of pixels to the next: one more, so that they do not lie 2 KiB apart,
/// where they would share the cache's banks.
constexpr int kBlockVectors = kNibbles + 1;
constexpr int kPixelsAtOnce = 2;  ///< left pixels: times kVectorsAtOnce, 12 sums
/// Vectors of right pixels at a time: with two left pixels 12 sums, which fit into 16 registers.
constexpr int kVectorsAtOnce = 6;

using DBytes = hn::ScalableTag<std::uint8_t>;
using DKeys = hn::Repartition<std::uint16_t, DBytes>;
using VKeys = hn::Vec<DKeys>;  ///< cost * 256 + disparity: of equal costs the nearest one is less

/// The bytes of a row as nibbles: a block, a vector of pixels, has its kNibbles vectors in a row.
/// @param kShift left, 4 for offsets of tables.
template <int kShift>
HWY_INLINE void SplitNibbles(const DescriptorRow& from, int width, std::uint8_t* HWY_RESTRICT to) {
  const DBytes d8;
  const hn::Repartition<std::uint16_t, DBytes> d16;
  const int step = static_cast<int>(hn::Lanes(d8));
  const auto mask = hn::Set(d8, static_cast<std::uint8_t>(15 << kShift));
  for (int x = 0; x < width; x += step, to += (kBlockVectors - kNibbles) * step) {
    for (int p = 0; p < kDescriptorPoints; ++p, to += 2 * step) {
      const auto bytes = hn::LoadU(d8, from.data + p * from.stride + x);
      const auto words = hn::BitCast(d16, bytes);
      const auto low = kShift == 0 ? words : hn::ShiftLeft<kShift>(words);
      const auto high = hn::ShiftRight<4 - kShift>(words);
      hn::StoreU(hn::And(hn::BitCast(d8, low), mask), d8, to);
      hn::StoreU(hn::And(hn::BitCast(d8, high), mask), d8, to + step);
    }
  }
}

/// Nothing, but v is in a register here: left alone GCC 12 loads it again for every use.
template <class V>
HWY_INLINE void HoldInRegister(V& v) {
  asm volatile("" : "+x"(v.raw));
}

/// Two left pixels against kCount vectors of right pixels.
/// @param left the first one's nibbles as offsets, a vector apart.
/// @param ahead columns from the first left pixel to the first right one; none is positive.
template <int kCount>
HWY_INLINE void MatchVectors(const std::uint8_t* HWY_RESTRICT left,
                             const std::uint8_t* HWY_RESTRICT right, const CandidateTable& table,
                             int ahead, VKeys* keys) {
  const DBytes d8;
  const DKeys d16;
  const int step = static_cast<int>(hn::Lanes(d8));
  hn::Vec<DBytes> sums[kPixelsAtOnce][kCount];
#pragma GCC unroll 6
  for (int b = 0; b < kCount; ++b) sums[0][b] = sums[1][b] = hn::Zero(d8);
  auto differing = [&](int pixel) {
    return hn::LoadDup128(d8, kDifferingBits.data() + left[pixel]);
  };
  // All but the last nibble make 252 bits at most.
  constexpr int kUnrolled = 7;
  static_assert((kNibbles - 1) % kUnrolled == 0);
  for (int n = 0; n < kNibbles - 1; n += kUnrolled) {
#pragma GCC unroll 7
    for (int k = 0; k < kUnrolled; ++k, left += step, right += step) {
      const auto table0 = differing(0), table1 = differing(1);
#pragma GCC unroll 6
      for (int b = 0; b < kCount; ++b) {
        auto nibble = hn::Load(d8, right + b * kBlockVectors * step);
        HoldInRegister(nibble);
        sums[0][b] = hn::Add(sums[0][b], hn::TableLookupBytes(table0, nibble));
        HoldInRegister(sums[0][b]);
        sums[1][b] = hn::Add(sums[1][b], hn::TableLookupBytes(table1, nibble));
        HoldInRegister(sums[1][b]);
      }
    }
  }
#pragma GCC unroll 2
  for (int pixel = 0; pixel < kPixelsAtOnce; ++pixel) {
    const auto last = differing(pixel);
#pragma GCC unroll 6
    for (int b = 0; b < kCount; ++b) {
      const auto nibble = hn::Load(d8, right + b * kBlockVectors * step);
      const int at = CandidateTable::kOrigin + ahead + b * step - pixel;
      const auto bits = hn::SaturatedAdd(sums[pixel][b], hn::TableLookupBytes(last, nibble));
      const auto cost = hn::Or(bits, hn::LoadU(d8, table.none.data() + at));
      const auto disparity = hn::LoadU(d8, kDisparities.data() + at);
      const auto low = hn::BitCast(d16, hn::InterleaveLower(d8, disparity, cost));
      const auto high = hn::BitCast(d16, hn::InterleaveUpper(d8, disparity, cost));
      keys[pixel] = hn::Min(keys[pixel], hn::Min(low, high));
    }
  }
}

/// As MatchVectors; count is 1 .. kVectorsAtOnce.
HWY_INLINE void MatchSomeVectors(int count, const std::uint8_t* left, const std::uint8_t* right,
                                 const CandidateTable& table, int ahead, VKeys* keys) {
  switch (count) {
    case 1:
      return MatchVectors<1>(left, right, table, ahead, keys);
    case 2:
      return MatchVectors<2>(left, right, table, ahead, keys);
    case 3:
      return MatchVectors<3>(left, right, table, ahead, keys);
    case 4:
      return MatchVectors<4>(left, right, table, ahead, keys);
    case 5:
      return MatchVectors<5>(left, right, table, ahead, keys);
    default:
      return MatchVectors<6>(left, right, table, ahead, keys);
  }
}

HWY_INLINE int SmallestKey(VKeys keys) {
#if HWY_MAX_BYTES >= 32
  const hn::Half<DKeys> half;
  const auto smaller = hn::Min(hn::LowerHalf(half, keys), hn::UpperHalf(half, keys));
  return hn::GetLane(hn::MinOfLanes(half, smaller));
#else
  return hn::GetLane(hn::MinOfLanes(DKeys(), keys));
#endif
}

void BestMatchesByTables(const MatchRow& row) {
  const int step = static_cast<int>(hn::Lanes(DBytes()));
  const CandidateTable table(row.candidates);
  std::uint8_t* left = row.nibbles;
  std::uint8_t* right = left + kBlockVectors * ((row.width + step - 1) / step * step);
  SplitNibbles<4>(row.left, row.width, left);
  SplitNibbles<0>(row.right, row.width, right);
  for (int x = 0; x < row.width; x += kPixelsAtOnce) {
    // A cost of 255 never wins against this.
    VKeys keys[kPixelsAtOnce] = {hn::Set(DKeys(), 255 << 8), hn::Set(DKeys(), 255 << 8)};
    int block = std::max(0, x - row.candidates + 1) / step;
    const int end = x / step + 1;
    while (block < end) {
      const int parts = (end - block + kVectorsAtOnce - 1) / kVectorsAtOnce;
      const int count = (end - block + parts - 1) / parts;
      MatchSomeVectors(count, left + x / step * step * kBlockVectors + x % step,
                       right + block * step * kBlockVectors, table, block * step - x, keys);
      block += count;
    }
    for (int pixel = 0; pixel < kPixelsAtOnce; ++pixel) {
      const int key = SmallestKey(keys[pixel]);
      row.smallest[x + pixel] = static_cast<std::uint8_t>(key >> 8);
      row.best[x + pixel] = static_cast<std::uint8_t>(key & 255);
    }
  }
}

}  // namespace striate::perception::stereo_kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif  // STRIATE_MATCH_BY_TABLES
#endif  // once for every instruction set
