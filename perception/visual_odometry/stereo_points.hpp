#pragma once

#include <cstdint>
#include <vector>

#include "striate/perception/visual_odometry/feature_matching.hpp"
#include "striate/perception/visual_odometry/odometry_settings.hpp"
#include "striate/perception/visual_odometry/patch_place.hpp"
#include "striate/perception/visual_odometry/stereo_eyes.hpp"

namespace striate::perception {

/// A point that both eyes see.
struct StereoPoint {
  std::size_t left = 0;  ///< its feature
  std::size_t right = 0;
  StereoSight sight;
  int level = 0;            ///< of the pyramid, on which its place was found
  std::int64_t track = 0;   ///< the same in all images of one point
  double then_noise = 1.0;  ///< of the disparity; less where many images have told it
};

/// What one view holds for odometry.
struct StereoLook {
  StereoEyes eyes;
  cv::Size size;
  PicturePyramid left_picture, right_picture;
  double noise = 0.0;  ///< of the left picture, grey levels
  FeatureSet left, right;
  std::vector<StereoPoint> points;
};

/// Matches the eyes' features, and measures the disparities to a small part of a pixel.
void look_with_both(const StereoView& view, const FeatureSource& source,
                    const VisualOdometrySettings& settings, StereoLook& look);

/// How many of the left eye's features lie where more than noise is to be seen.
[[nodiscard]] int count_with_contrast(const StereoLook& look);

}  // namespace striate::perception
