#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "striate/perception/matching/descriptor_store.hpp"
#include "striate/perception/matching/search_kernels.hpp"

namespace striate::perception {

/// A stored descriptor that is near a query.
struct Match {
  std::uint32_t query = 0;
  std::uint32_t stored = 0;
  std::uint32_t distance_bits = 0;
  friend bool operator==(const Match&, const Match&) = default;
};

/// The two nearest stored descriptors of one query.
struct NearestTwo {
  static constexpr std::uint32_t kNone = 0xFFFFFFFF;  ///< no index: no store holds so many
  std::uint32_t first = kNone;                        ///< index; kNone: none below the limit
  std::uint32_t second = kNone;
  std::uint32_t first_bits = 257;  ///< Hamming distances; 257, more than any, where there is none
  std::uint32_t second_bits = 257;
  friend bool operator==(const NearestTwo&, const NearestTwo&) = default;
};

/// Exact search by Hamming distance; nothing is approximated, and every instruction set gives the
/// same answer. Keeps its buffers: what is returned is valid until the next search.
class HammingSearch {
 public:
  /// All pairs with a distance below `limit_bits`, by query and then by stored index.
  std::span<const Match> below(std::span<const Descriptor> queries, const DescriptorStore& store,
                               std::uint32_t limit_bits);

  /// One entry a query: the nearest and the second nearest below `limit_bits`; of equally near ones
  /// that with the lower index first.
  std::span<const NearestTwo> nearest_two(std::span<const Descriptor> queries,
                                          const DescriptorStore& store,
                                          std::uint32_t limit_bits = 257);

 private:
  template <class Limit, class Take>
  void search(std::span<const Descriptor> queries, const DescriptorStore& store, Limit limit,
              Take take);
  void sort_by_query(std::size_t query_count);

  std::vector<search_kernels::Found> found_;
  std::vector<Match> unsorted_;
  std::vector<Match> matches_;
  std::vector<std::size_t> starts_;
  std::vector<NearestTwo> nearest_;
};

}  // namespace striate::perception
