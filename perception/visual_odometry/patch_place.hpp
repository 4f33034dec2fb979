#pragma once

#include <array>
#include <opencv2/core/mat.hpp>
#include <opencv2/core/matx.hpp>

namespace striate::perception {

/// An image at its size, half of it and a quarter, where coarse things are looked at.
struct PicturePyramid {
  static constexpr int kLevels = 3;
  std::array<cv::Mat1b, kLevels> level;

  void build(const cv::Mat1b& grey);
};

struct PatchSettings {
  double most_shift_px = 2.5;    ///< from where it is looked for, on each level: keypoints err less
  double least_likeness = 0.75;  ///< normalised correlation; below it something else is there
  double least_contrast = 3.0;   ///< standard deviation of the patch, grey levels of 255
};

/// Where a patch is found.
struct PatchPlace {
  enum class Result { found, outside, without_contrast, unlike } result = Result::outside;
  double u_px = 0.0;
  double v_px = 0.0;
};

/// Looks in `image`, near `start`, for what `reference` shows at `at`, to a small part of a pixel
/// (Lucas and Kanade 1981, inverse composition after Baker and Matthews 2004); light may have
/// changed by a factor and an offset. Places are of level 0.
/// @param back pixels of the reference a pixel of the image: turn and scale
[[nodiscard]] PatchPlace find_patch(const PicturePyramid& reference, cv::Point2d at,
                                    const PicturePyramid& image, cv::Point2d start,
                                    const cv::Matx22d& back, int level,
                                    const PatchSettings& settings);

}  // namespace striate::perception
