#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "striate/perception/matching/descriptor_store.hpp"

/// The inner loop of searching: a few queries against a stretch of stored descriptors that stays in
/// the first cache.
namespace striate::perception::search_kernels {

/// Queries; times kBlocksAtOnce sums, that many registers of the 16 there are
inline constexpr std::size_t kQueriesAtOnce = 4;
/// Blocks of 8 descriptors whose sums stay in registers
inline constexpr std::size_t kBlocksAtOnce = 2;
inline constexpr std::size_t kBlocksOfChunk = 64;  ///< 512 descriptors, 16 KiB
inline constexpr std::size_t kMostFound =
    kQueriesAtOnce * kBlocksOfChunk * DescriptorBlock::kSize;  ///< of one call

/// Four queries; unused ones have limit 0, which nothing is below.
struct QueryGroup {
  std::array<std::array<std::uint64_t, 4>, kQueriesAtOnce> words{};  ///< as they are stored
  std::array<std::uint32_t, kQueriesAtOnce> limit{};  ///< distances below it are wanted, 0..257
};

struct Found {
  std::uint32_t query;     ///< of the group
  std::uint32_t stored;    ///< of the chunk
  std::uint32_t distance;  ///< below the query's limit
};

/// What a first pass compares with the limits: a lower bound of the distance. The answer is the
/// same with each; the first costs half of the last, but lets more through when descriptors are
/// alike.
enum class Bound { any_of_four, any_of_two, full };

struct Tally {
  std::size_t found;
  std::size_t passed;  ///< twos of blocks that the bound could not rule out
};

/// Everything below the limits. For one query the finds come in the order of `stored`.
/// @param blocks an even number, at most kBlocksOfChunk.
/// @param found room for kMostFound + 1.
Tally search_chunk(std::span<const DescriptorBlock> blocks, const QueryGroup& queries, Bound bound,
                   Found* found);

}  // namespace striate::perception::search_kernels
