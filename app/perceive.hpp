#pragma once

#include "striate/app/perceive_frame.hpp"
#include "striate/app/perceive_options.hpp"

namespace striate::app {

/// A pair of images, and what the vision found in it.
struct JudgedPair {
  StereoFrame frame;
  JudgedFrame judged;
};

/// Writes into `options.out`: disparity.pfm and confidence.pfm (float, working size, left frame,
/// bottom row first, little-endian; +inf is no trusted match), obstacles.json, saliency.png,
/// keypoints.json and overview.png. Images may be grey or colour, 8 to 16 bit, with alpha. The
/// disparities are those of the images as they are given, whatever their principal points.
/// @throws UserError for images that cannot be used and for impossible options,
/// std::runtime_error where `out` cannot be written
JudgedPair perceive(const PerceiveOptions& options);

}  // namespace striate::app
