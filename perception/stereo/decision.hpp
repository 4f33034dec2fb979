#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "striate/perception/percept.hpp"
#include "striate/perception/stereo/gap_filling.hpp"
#include "striate/perception/stereo/semi_global.hpp"
#include "striate/perception/stereo/speckles.hpp"
#include "striate/perception/stereo/stereo_settings.hpp"
#include "striate/perception/stereo/winner_kernels.hpp"
#include "striate/perception/v1/v1_cells.hpp"

namespace striate::perception {

/// What a pixel's disparity rests on; integers, so that every machine decides alike.
struct StereoEvidence {
  int margin = 0;      ///< smoothed cost of the runner-up minus the winner's, sums of 8 paths
  int sum = 0;         ///< smoothed cost of the winner, sum of 8 paths
  int raw_margin = 0;  ///< raw cost of the best other disparity minus the winner's; may be negative
  int cost = 0;        ///< raw Hamming distance of the winner, bits
  int texture = 0;     ///< code of the strongest complex cell, from its least value: 2048 an octave
  int disparity_px = 1;  ///< the winner's, whole
};

/// From smoothed costs to disparities: which to trust, and how much. Keeps its buffers.
class Decision {
 public:
  explicit Decision(const RobustStereoSettings& settings);

  struct Input {
    const Volume<std::uint8_t>& costs;   ///< raw Hamming costs
    const Plane<std::uint8_t>& outside;  ///< see SmoothedRow
    const V1Responses& left;
    int candidates = 0;
  };
  void begin(const Input& input);
  /// All rows, in any order.
  void decide_row(const Input& input, int y, const SmoothedCosts& smoothed, DisparityMap& out);
  /// After the last row: what needs the neighbourhood.
  void finish(DisparityMap& out);

 private:
  void find_winners(const Input& input, int y, const SmoothedCosts& smoothed);
  void drop_patterns(DisparityMap& out);
  [[nodiscard]] float sub_pixel(int best, int x, int limit) const;

  RobustStereoSettings settings_;
  float least_confidence_;
  Speckles speckles_;
  GapFilling gaps_;
  cv::Mat1b repeated_;  ///< 1 where another disparity matches about as well, 2 with contrast
  cv::Mat1b counted_;
  cv::Mat1f pattern_share_, known_share_;
  Plane<std::uint16_t> sums_;      ///< of one row, [disparity][column]
  Plane<std::int16_t> strongest_;  ///< row 0: code of the strongest complex cell
  Plane<std::uint16_t> winners_;   ///< rows: best, smallest, second, raw_second, right_best
};

/// In steps of 1/1000; 0: the evidence says nothing.
[[nodiscard]] float stereo_confidence(const StereoEvidence& evidence, StereoConfidence measure);

/// StereoConfidence::promise, from the score: the share of such disparities that is right within
/// 1 px, as both eyes see them.
[[nodiscard]] float promise_of(float score);

}  // namespace striate::perception
