#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

/// Tables of matching by nibbles; see match_tables-inl.hpp.
namespace striate::perception::stereo_kernels {

/// At 16 a + b: the bits in which nibbles a and b differ.
alignas(64) inline constexpr auto kDifferingBits = [] {
  std::array<std::uint8_t, 256> result{};
  for (unsigned k = 0; k < result.size(); ++k) {
    result[k] = static_cast<std::uint8_t>(std::popcount((k >> 4U) ^ (k & 15U)));
  }
  return result;
}();

/// At kOrigin - d: 255 where disparity d is no candidate, else 0.
struct CandidateTable {
  static constexpr int kOrigin = 256 + 64;      ///< the last candidate is in a vector's middle
  static constexpr int kLength = kOrigin + 64;  ///< likewise the first

  std::array<std::uint8_t, kLength> none;

  explicit CandidateTable(int candidates) {
    none.fill(255);
    std::fill(none.begin() + kOrigin + 1 - candidates, none.begin() + kOrigin + 1, std::uint8_t{0});
  }
};

/// At kOrigin - d: the lowest byte of d.
alignas(64) inline constexpr auto kDisparities = [] {
  std::array<std::uint8_t, CandidateTable::kLength> result{};
  for (int k = 0; k < CandidateTable::kLength; ++k) {
    result[static_cast<std::size_t>(k)] = static_cast<std::uint8_t>(CandidateTable::kOrigin - k);
  }
  return result;
}();

}  // namespace striate::perception::stereo_kernels
