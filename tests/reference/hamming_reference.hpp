#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "striate/perception/matching/hamming_search.hpp"

/// Searching descriptors as the definitions say it, bit by bit and by sorting: nothing here is
/// shaped like the code that it judges.
namespace striate::reference {

/// The definition in percept.hpp: bit b is words[b / 64] >> (b % 64) & 1.
inline bool bit_of(const perception::Descriptor& descriptor, std::size_t b) {
  return (descriptor.words.at(b / 64) >> (b % 64) & 1U) != 0;
}

inline std::uint32_t distance_bits(const perception::Descriptor& a,
                                   const perception::Descriptor& b) {
  std::uint32_t differ = 0;
  for (std::size_t bit = 0; bit < 256; ++bit) differ += bit_of(a, bit) != bit_of(b, bit) ? 1 : 0;
  return differ;
}

inline std::vector<perception::Match> matches_below(std::span<const perception::Descriptor> queries,
                                                    std::span<const perception::Descriptor> stored,
                                                    std::uint32_t limit_bits) {
  std::vector<perception::Match> all;
  for (std::size_t pair = 0; pair < queries.size() * stored.size(); ++pair) {
    const std::size_t q = pair / stored.size();
    const std::size_t s = pair % stored.size();
    all.push_back({static_cast<std::uint32_t>(q), static_cast<std::uint32_t>(s),
                   distance_bits(queries[q], stored[s])});
  }
  std::erase_if(all,
                [&](const perception::Match& match) { return match.distance_bits >= limit_bits; });
  return all;
}

/// Of those at the same distance, the one stored first is nearer.
inline std::vector<perception::NearestTwo> nearest_two(
    std::span<const perception::Descriptor> queries, std::span<const perception::Descriptor> stored,
    std::uint32_t limit_bits) {
  std::vector<perception::NearestTwo> result(queries.size());
  for (std::size_t q = 0; q < queries.size(); ++q) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> ranked;  // bits, stored
    for (const perception::Match& match :
         matches_below(queries.subspan(q, 1), stored, limit_bits)) {
      ranked.emplace_back(match.distance_bits, match.stored);
    }
    std::sort(ranked.begin(), ranked.end());
    if (!ranked.empty()) std::tie(result[q].first_bits, result[q].first) = ranked[0];
    if (ranked.size() > 1) std::tie(result[q].second_bits, result[q].second) = ranked[1];
  }
  return result;
}

/// A descriptor that differs from `from` in exactly `bits` places, which depend on the seed.
inline perception::Descriptor disturbed(perception::Descriptor from, int bits, unsigned seed) {
  // An odd step visits all 256 bits before it comes back.
  const unsigned step = 2 * (seed % 128) + 1;
  for (unsigned k = 0; k < static_cast<unsigned>(bits); ++k) {
    const unsigned bit = (seed / 128 + k * step) % 256;
    from.words[bit / 64] ^= std::uint64_t{1} << (bit % 64);
  }
  return from;
}

/// Descriptors of independent bits from a seed (a 64-bit mixing after Steele, Lea and Flood).
inline std::vector<perception::Descriptor> random_descriptors(std::size_t count,
                                                              std::uint64_t seed) {
  std::vector<perception::Descriptor> result(count);
  for (perception::Descriptor& descriptor : result) {
    for (std::uint64_t& word : descriptor.words) {
      std::uint64_t z = seed += 0x9E3779B97F4A7C15U;
      z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9U;
      z = (z ^ (z >> 27)) * 0x94D049BB133111EBU;
      word = z ^ (z >> 31);
    }
  }
  return result;
}

}  // namespace striate::reference
