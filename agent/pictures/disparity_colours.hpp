#pragma once

#include <opencv2/core/mat.hpp>

#include "striate/perception/percept.hpp"

namespace striate::agent::pictures {

/// What the colours of a disparity image stand for: blue far, red near.
struct DisparityScale {
  double most_px = 0.0;         ///< disparity that is fully red
  double focal_baseline = 0.0;  ///< px m; 0: unknown camera, the legend is in px
};

/// Fixed for a known camera (red at 0.7 m), so that colours mean the same in every image;
/// else, and where `metric` is not wanted, fitted to the map.
[[nodiscard]] DisparityScale scale_for(const perception::DisparityMap& map, bool metric = true);

/// Disparity in colour at `size`, pixels kept crisp; unknown is a dark hatch.
[[nodiscard]] cv::Mat3b colour_disparity(const perception::DisparityMap& map,
                                         const DisparityScale& scale, cv::Size size);

/// A bar of the colours with their distances (or disparities), drawn into `where`.
void draw_legend(cv::Mat3b& image, cv::Rect where, const DisparityScale& scale);

/// 0..1 as a heat colour from dark through red to yellow-white, for salience.
[[nodiscard]] cv::Vec3b heat_colour(double value);

}  // namespace striate::agent::pictures
