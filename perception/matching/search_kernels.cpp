#define HWY_WANT_AVX3_DL 1

#include "striate/perception/matching/search_kernels.hpp"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "striate/perception/matching/search_kernels.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h, which defines the target.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace striate::perception::search_kernels::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using D64 = hn::CappedTag<std::uint64_t, DescriptorBlock::kSize>;
using V64 = hn::Vec<D64>;

constexpr std::size_t kQueries = kQueriesAtOnce;  // queries that share each load of stored words

/// The words of one vector of stored descriptors.
struct Stored {
  V64 w0, w1, w2, w3;
};

HWY_INLINE Stored LoadStored(const DescriptorBlock& block, std::size_t lane) {
  const D64 d;
  return {hn::Load(d, block.words[0].data() + lane), hn::Load(d, block.words[1].data() + lane),
          hn::Load(d, block.words[2].data() + lane), hn::Load(d, block.words[3].data() + lane)};
}

/// The query's words in all lanes.
struct Query {
  V64 w0, w1, w2, w3;
};

HWY_INLINE Query SpreadQuery(const std::array<std::uint64_t, 4>& words) {
  const D64 d;
  return {hn::Set(d, words[0]), hn::Set(d, words[1]), hn::Set(d, words[2]), hn::Set(d, words[3])};
}

/// Bounds for the first pass: never more than the distance, and cheaper.
struct FullDistance {
  static HWY_INLINE V64 Of(const Stored& s, const Query& q) {
    const V64 low =
        hn::Add(hn::PopulationCount(hn::Xor(s.w0, q.w0)), hn::PopulationCount(hn::Xor(s.w1, q.w1)));
    const V64 high =
        hn::Add(hn::PopulationCount(hn::Xor(s.w2, q.w2)), hn::PopulationCount(hn::Xor(s.w3, q.w3)));
    return hn::Add(low, high);
  }
};

/// any | (stored ^ query), one instruction where there is one for three operands.
HWY_INLINE V64 OrDifferent(V64 any, V64 stored, V64 query) {
#if HWY_TARGET <= HWY_AVX3
  return V64{_mm512_ternarylogic_epi64(any.raw, stored.raw, query.raw, 0xF6)};
#else
  return hn::Or(any, hn::Xor(stored, query));
#endif
}

/// In two pairs of words, the bit positions at which any of the two differs: at most 128.
struct AnyOfTwoDiffers {
  static HWY_INLINE V64 Of(const Stored& s, const Query& q) {
    const V64 low = OrDifferent(hn::Xor(s.w0, q.w0), s.w1, q.w1);
    const V64 high = OrDifferent(hn::Xor(s.w2, q.w2), s.w3, q.w3);
    return hn::Add(hn::PopulationCount(low), hn::PopulationCount(high));
  }
};

/// The bit positions at which any of the four words differs: at most 64, and for unlike
/// descriptors near 60, far above a limit of 48.
struct AnyOfFourDiffers {
  static HWY_INLINE V64 Of(const Stored& s, const Query& q) {
    V64 any = hn::Xor(s.w0, q.w0);
    any = OrDifferent(any, s.w1, q.w1);
    any = OrDifferent(any, s.w2, q.w2);
    any = OrDifferent(any, s.w3, q.w3);
    return hn::PopulationCount(any);
  }
};

/// Of numbers below 2^31; a minimum of 64-bit elements is slow where there is one.
HWY_INLINE V64 Lesser(V64 a, V64 b) {
#if HWY_TARGET == HWY_SCALAR
  return hn::Min(a, b);
#else
  const D64 d;
  const hn::Repartition<std::int32_t, D64> d32;
  return hn::BitCast(d, hn::Min(hn::BitCast(d32, a), hn::BitCast(d32, b)));
#endif
}

/// Whether any element of `a` is below that of `b`; numbers below 2^31.
HWY_INLINE bool AnyBelow(V64 a, V64 b) {
#if HWY_TARGET == HWY_SCALAR
  return hn::GetLane(a) < hn::GetLane(b);
#else
  const hn::Repartition<std::int32_t, D64> d32;
  return !hn::AllFalse(d32, hn::Lt(hn::BitCast(d32, a), hn::BitCast(d32, b)));
#endif
}

/// Twos of blocks that may hold a distance below `limit`, in ascending order.
template <class Bits>
HWY_INLINE std::size_t Sift(std::span<const DescriptorBlock> blocks, const QueryGroup& queries,
                            std::uint32_t limit, std::uint32_t* HWY_RESTRICT passed) {
  const D64 d;
  const Query q0 = SpreadQuery(queries.words[0]), q1 = SpreadQuery(queries.words[1]);
  const Query q2 = SpreadQuery(queries.words[2]), q3 = SpreadQuery(queries.words[3]);
  const V64 limits = hn::Set(d, limit);
  std::size_t count = 0;
  for (std::size_t b = 0; b < blocks.size(); b += kBlocksAtOnce) {
    V64 least = hn::Set(d, 256);
    for (std::size_t k = 0; k < kBlocksAtOnce; ++k) {
      for (std::size_t lane = 0; lane < DescriptorBlock::kSize; lane += hn::Lanes(d)) {
        const Stored s = LoadStored(blocks[b + k], lane);
        const V64 a01 = Lesser(Bits::Of(s, q0), Bits::Of(s, q1));
        const V64 a23 = Lesser(Bits::Of(s, q2), Bits::Of(s, q3));
        least = Lesser(least, Lesser(a01, a23));
      }
    }
    passed[count] = static_cast<std::uint32_t>(b);
    count += AnyBelow(least, limits) ? 1U : 0U;
  }
  return count;
}

/// Exact distances of one query and two blocks.
HWY_INLINE std::size_t Verify(std::span<const DescriptorBlock> blocks, std::uint32_t block,
                              const Query& query, Found common, Found* HWY_RESTRICT found) {
  const D64 d;
  const V64 limits = hn::Set(d, common.distance);
  std::size_t count = 0;
  for (std::size_t k = 0; k < kBlocksAtOnce; ++k) {
    for (std::size_t lane = 0; lane < DescriptorBlock::kSize; lane += hn::Lanes(d)) {
      const V64 distance = FullDistance::Of(LoadStored(blocks[block + k], lane), query);
      if (!AnyBelow(distance, limits)) continue;
      HWY_ALIGN std::uint64_t distances[DescriptorBlock::kSize];
      hn::Store(distance, d, distances);
      for (std::size_t i = 0; i < hn::Lanes(d); ++i) {
        const std::size_t stored = (block + k) * DescriptorBlock::kSize + lane + i;
        found[count] = {common.query, static_cast<std::uint32_t>(stored),
                        static_cast<std::uint32_t>(distances[i])};
        count += distances[i] < common.distance ? 1U : 0U;
      }
    }
  }
  return count;
}

Tally SearchChunk(std::span<const DescriptorBlock> blocks, const QueryGroup& queries, Bound bound,
                  Found* HWY_RESTRICT found) {
  const std::uint32_t limit = *std::max_element(queries.limit.begin(), queries.limit.end());
  std::uint32_t passed[kBlocksOfChunk / kBlocksAtOnce + 1];
  std::size_t passed_count = 0;
  switch (bound) {
    case Bound::any_of_four:
      passed_count = Sift<AnyOfFourDiffers>(blocks, queries, limit, passed);
      break;
    case Bound::any_of_two:
      passed_count = Sift<AnyOfTwoDiffers>(blocks, queries, limit, passed);
      break;
    case Bound::full:
      passed_count = Sift<FullDistance>(blocks, queries, limit, passed);
  }
  std::size_t count = 0;
  for (std::size_t p = 0; p < passed_count; ++p) {
    for (std::size_t q = 0; q < kQueries; ++q) {
      const Found common{static_cast<std::uint32_t>(q), 0, queries.limit[q]};
      count += Verify(blocks, passed[p], SpreadQuery(queries.words[q]), common, found + count);
    }
  }
  return {count, passed_count};
}

}  // namespace striate::perception::search_kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace striate::perception::search_kernels {

HWY_EXPORT(SearchChunk);

Tally search_chunk(std::span<const DescriptorBlock> blocks, const QueryGroup& queries, Bound bound,
                   Found* found) {
  return HWY_DYNAMIC_DISPATCH(SearchChunk)(blocks, queries, bound, found);
}

}  // namespace striate::perception::search_kernels
#endif
