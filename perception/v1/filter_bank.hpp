#pragma once

#include <cstdint>
#include <vector>

#include "striate/perception/v1/v1_settings.hpp"

namespace striate::perception {

/// The Gabor kernels as short integer filters along rows and columns.
///
/// The carrier is separable; the envelope is a sum of `kRank` products (singular value
/// decomposition; one product suffices on the axes and with gamma = 1). theta and pi - theta are
/// mirror images and share every pass: a product's column sums go to one of two slots, and the
/// sum of both slots is the response at theta, their difference the one at pi - theta.
///
/// Everything is integer arithmetic, exact but for one rounding per pass, so that every
/// instruction set gives the same bits:
///   x = 16 (grey - 128);  row = (sum taps x + 2^(kRowShift-1)) >> kRowShift            (16 bit)
///   slot = sum over products, sum taps row                                        (32 bit)
///   box = (sum of x over the support + 8) >> kGreyShift
///   response = (slot0 +- slot1 + offset - box_factor * box + 2^15) >> kColumnShift        (16 bit)
/// The response is `gain` times the exact one (grey 0..255, kernel as in V1Settings).
struct FilterBank {
  /// Products a kernel: 1.7 % of descriptor bits differ from double precision (at most 2 % tested)
  static constexpr int kRank = 3;
  static constexpr int kGreyShift = 4;  ///< greys come in sixteenths
  /// Row taps have 8 bits of fraction, greys four
  static constexpr int kRowShift = 8 + kGreyShift;
  /// Bits of fraction in a column's sums: their upper half is the response
  static constexpr int kColumnShift = 16;

  /// One row filter and the two column filters on its output.
  struct Product {
    std::vector<std::int16_t> row;          ///< 2 * radius + 1 taps; even or odd about the middle
    std::vector<std::int16_t> column_even;  ///< feeds the even responses' slot
    std::vector<std::int16_t> column_odd;   ///< feeds the odd responses' slot
    int slot = 0;
  };
  /// The orientations theta_i and pi - theta_i.
  struct Pair {
    int orientation = 0;
    int mirrored = -1;  ///< its partner; -1: none
    std::vector<Product> products;
    std::int32_t offset = 0;      ///< added to the even sum: what x = grey - 128 took away
    std::int32_t box_factor = 0;  ///< removes the even kernel's mean, or what rank 3 did to it
  };

  int radius = 0;      ///< of all taps; at most that of the support, less where taps are zero
  int box_radius = 0;  ///< of the support
  double gain = 1.0;
  std::vector<Pair> pairs;
};

[[nodiscard]] FilterBank make_filter_bank(const V1Settings& settings);

}  // namespace striate::perception
