#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <opencv2/core/matx.hpp>

namespace striate::evaluation {

/// A grey image made by rule, with the statistics of photographs: things of all sizes that hide
/// each other (dead leaves), each with its own texture whose spectrum falls like 1/f, shading,
/// writing, bricks and bars. The same seed is the same image.
[[nodiscard]] cv::Mat1b synthetic_image(cv::Size size, std::uint64_t seed);

/// The same scene seen by another camera at another time.
struct SecondView {
  cv::Mat1b image;
  cv::Matx33d homography;  ///< from the first image to this one
};

/// Another viewpoint (turn, zoom, tilt), then blur (at times), gamma, exposure and noise.
[[nodiscard]] SecondView second_view(const cv::Mat1b& image, std::uint64_t seed);

}  // namespace striate::evaluation
