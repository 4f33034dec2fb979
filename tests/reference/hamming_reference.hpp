#pragma once

#include <bit>
#include <span>
#include <vector>

#include "perception/matching/hamming_search.hpp"

/// Searching descriptors as one would write it down: two loops and a population count.
namespace striate::reference {

inline std::uint32_t distance_bits(const Descriptor& a, const Descriptor& b) {
  int bits = 0;
  for (std::size_t w = 0; w < 4; ++w) bits += std::popcount(a.words[w] ^ b.words[w]);
  return static_cast<std::uint32_t>(bits);
}

inline std::vector<Match> matches_below(std::span<const Descriptor> queries,
                                        std::span<const Descriptor> stored,
                                        std::uint32_t limit_bits) {
  std::vector<Match> result;
  for (std::uint32_t q = 0; q < queries.size(); ++q) {
    for (std::uint32_t s = 0; s < stored.size(); ++s) {
      const std::uint32_t bits = distance_bits(queries[q], stored[s]);
      if (bits < limit_bits) result.push_back({q, s, bits});
    }
  }
  return result;
}

inline std::vector<NearestTwo> nearest_two(std::span<const Descriptor> queries,
                                           std::span<const Descriptor> stored,
                                           std::uint32_t limit_bits) {
  std::vector<NearestTwo> result(queries.size());
  for (const Match& match : matches_below(queries, stored, limit_bits)) {
    NearestTwo& best = result[match.query];
    if (match.distance_bits < best.first_bits) {
      best.second = best.first;
      best.second_bits = best.first_bits;
      best.first = match.stored;
      best.first_bits = match.distance_bits;
    } else if (match.distance_bits < best.second_bits) {
      best.second = match.stored;
      best.second_bits = match.distance_bits;
    }
  }
  return result;
}

/// A descriptor that differs from `from` in exactly `bits` places, which depend on the seed.
inline Descriptor disturbed(Descriptor from, int bits, unsigned seed) {
  // An odd step visits all 256 bits before it comes back.
  const unsigned step = 2 * (seed % 128) + 1;
  for (unsigned k = 0; k < static_cast<unsigned>(bits); ++k) {
    const unsigned bit = (seed / 128 + k * step) % 256;
    from.words[bit / 64] ^= std::uint64_t{1} << (bit % 64);
  }
  return from;
}

/// Descriptors of independent bits from a seed (a 64-bit mixing after Steele, Lea and Flood).
inline std::vector<Descriptor> random_descriptors(std::size_t count, std::uint64_t seed) {
  std::vector<Descriptor> result(count);
  for (Descriptor& descriptor : result) {
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
