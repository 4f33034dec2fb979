#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>

namespace striate::evaluation {

/// A stereo pair made by rule, with its truth.
struct SyntheticPair {
  cv::Mat1w left, right;  ///< sixteenths of a grey level, as of to_fine_working_size
  cv::Mat1f truth_px;     ///< disparity; NaN where only the left eye sees
};

/// A room of slanted planes in front of each other, of all shapes and sizes, with textures of
/// synthetic_image from strong to none, seen by two eyes and drawn at four times the size. The
/// eyes differ in exposure, sharpness and noise: little in every other scene, in the rest up to
/// a gain of 1.5 and 9 grey levels of noise. The same seed is the same pair.
/// @param size of the result; disparities are up to 0.3 of the width.
[[nodiscard]] SyntheticPair synthetic_stereo(cv::Size size, std::uint64_t seed);

}  // namespace striate::evaluation
