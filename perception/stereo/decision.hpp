#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "perception/percept.hpp"
#include "perception/stereo/semi_global.hpp"
#include "perception/stereo/stereo_settings.hpp"
#include "perception/v1/v1_cells.hpp"

namespace striate {

/// From smoothed costs to disparities: which to trust, and how much.
class Decision {
 public:
  explicit Decision(const RobustStereoSettings& settings) : settings_(settings) {}

  struct Evidence {
    const Volume<std::uint8_t>& costs;  ///< raw Hamming costs
    const Volume<std::uint16_t>& sums;  ///< smoothed, sums of 8 paths
    const V1Responses& left;            ///< for the texture
    int candidates = 0;
  };
  void decide(const Evidence& evidence, DisparityMap& out);

 private:
  void decide_row(const Evidence& evidence, int y, DisparityMap& out);
  void drop_speckles(DisparityMap& out);

  RobustStereoSettings settings_;
  std::vector<int> left_best_, right_best_, stack_, piece_;
};

}  // namespace striate
