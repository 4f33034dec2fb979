#include "striate/perception/matching/hamming_search.hpp"

#include <algorithm>

namespace striate::perception {

using search_kernels::Bound;
using search_kernels::kBlocksOfChunk;
using search_kernels::kQueriesAtOnce;

namespace {

/// The cheapest bound that rules out most of what it is shown. What is found does not depend on it.
class BoundChoice {
 public:
  [[nodiscard]] Bound next(const search_kernels::QueryGroup& group) {
    const std::uint32_t limit = std::ranges::max(group.limit);
    // A bound can say no more than 64 or 128 bits.
    const Bound least = limit <= 64    ? Bound::any_of_four
                        : limit <= 128 ? Bound::any_of_two
                                       : Bound::full;
    // Now and then the cheaper one is tried again.
    const bool retry = ++calls_ % 16 == 0 && bound_ != Bound::any_of_four;
    used_ = std::max(least, retry ? Bound{static_cast<int>(bound_) - 1} : bound_);
    return used_;
  }
  void learn(std::size_t passed, std::size_t shown) {
    const bool useless = 3 * passed > shown;
    bound_ = useless && used_ != Bound::full ? Bound{static_cast<int>(used_) + 1} : used_;
  }

 private:
  Bound bound_ = Bound::any_of_four, used_ = bound_;
  int calls_ = 0;
};

}  // namespace

/// Every chunk of the store stays in the first cache while all queries pass over it.
/// @param limit of a query, by index, as it stands. @param take is called with each match below it.
template <class Limit, class Take>
void HammingSearch::search(std::span<const Descriptor> queries, const DescriptorStore& store,
                           Limit limit, Take take) {
  found_.resize(search_kernels::kMostFound + 1);
  BoundChoice choice;
  const std::span<const DescriptorBlock> blocks = store.blocks();
  for (std::size_t b = 0; b < blocks.size(); b += kBlocksOfChunk) {
    const auto chunk = blocks.subspan(b, std::min(kBlocksOfChunk, blocks.size() - b));
    const std::size_t from = b * DescriptorBlock::kSize;
    for (std::size_t q = 0; q < queries.size(); q += kQueriesAtOnce) {
      search_kernels::QueryGroup group;
      for (std::size_t k = 0; k < std::min(kQueriesAtOnce, queries.size() - q); ++k) {
        group.words[k] = stored_words(queries[q + k]);
        group.limit[k] = limit(q + k);
      }
      const auto tally =
          search_kernels::search_chunk(chunk, group, choice.next(group), found_.data());
      choice.learn(tally.passed, chunk.size() / search_kernels::kBlocksAtOnce);
      for (const search_kernels::Found& found : std::span(found_).first(tally.found)) {
        const std::size_t stored = from + found.stored;
        if (stored >= store.size()) continue;  // behind the last one
        take(Match{static_cast<std::uint32_t>(q) + found.query, static_cast<std::uint32_t>(stored),
                   found.distance});
      }
    }
  }
}

std::span<const Match> HammingSearch::below(std::span<const Descriptor> queries,
                                            const DescriptorStore& store,
                                            std::uint32_t limit_bits) {
  unsorted_.clear();
  search(
      queries, store, [&](std::size_t) { return limit_bits; },
      [&](const Match& match) { unsorted_.push_back(match); });
  sort_by_query(queries.size());
  return matches_;
}

/// Counting sort, stable: the matches of each query already come by stored index.
void HammingSearch::sort_by_query(std::size_t query_count) {
  starts_.assign(query_count + 1, 0);
  for (const Match& match : unsorted_) ++starts_[match.query + 1];
  for (std::size_t q = 1; q <= query_count; ++q) starts_[q] += starts_[q - 1];
  matches_.resize(unsorted_.size());
  for (const Match& match : unsorted_) matches_[starts_[match.query]++] = match;
}

std::span<const NearestTwo> HammingSearch::nearest_two(std::span<const Descriptor> queries,
                                                       const DescriptorStore& store,
                                                       std::uint32_t limit_bits) {
  nearest_.assign(queries.size(), NearestTwo{});
  search(
      queries, store, [&](std::size_t q) { return std::min(limit_bits, nearest_[q].second_bits); },
      [&](const Match& match) {
        NearestTwo& best = nearest_[match.query];
        if (match.distance_bits < best.first_bits) {
          best.second = best.first;
          best.second_bits = best.first_bits;
          best.first = match.stored;
          best.first_bits = match.distance_bits;
        } else if (match.distance_bits < best.second_bits) {
          best.second = match.stored;
          best.second_bits = match.distance_bits;
        }
      });
  return nearest_;
}

}  // namespace striate::perception
