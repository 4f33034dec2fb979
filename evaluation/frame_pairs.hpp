#pragma once

#include <cstdint>
#include <opencv2/core/matx.hpp>
#include <opencv2/core/types.hpp>
#include <vector>

#include "striate/evaluation/patch_set.hpp"

namespace striate::evaluation {

/// How well a frame that was found in the second image must agree with the one that the
/// homography predicts.
struct FrameTolerance {
  double position_sizes = 0.5;  ///< distance over the predicted frame's diameter
  double scale_octaves = 0.5;
  double angle_deg = 30.0;
};

/// The same SIFT frame in two images.
struct FramePair {
  cv::KeyPoint first, second;  ///< size is the diameter, 2 sigma; angle in degrees, u to v
};

/// A frame's patch spans this many diameters (16 sigma; SIFT's own reaches over 15).
inline constexpr double kPatchSizes = 8.0;

/// Frames whose patch lies within the image.
[[nodiscard]] std::vector<cv::KeyPoint> sift_frames(const cv::Mat1b& image);

/// Where the homography takes a frame: position, diameter and orientation by its local derivative.
[[nodiscard]] cv::KeyPoint predicted(const cv::KeyPoint& frame, const cv::Matx33d& homography);

/// Each frame with the nearest one that agrees; no frame stands in two pairs.
[[nodiscard]] std::vector<FramePair> frame_pairs(const std::vector<cv::KeyPoint>& first,
                                                 const std::vector<cv::KeyPoint>& second,
                                                 const cv::Matx33d& homography,
                                                 const FrameTolerance& tolerance);

/// A image at its full size, half, a quarter ...: what patches are cut from without aliasing.
[[nodiscard]] std::vector<cv::Mat1b> halvings(const cv::Mat1b& image);

/// The patch around a frame, turned upright.
[[nodiscard]] cv::Mat1b cut_patch(const std::vector<cv::Mat1b>& halvings,
                                  const cv::KeyPoint& frame);

/// Adds the patches of at most `most` frame pairs, as true pairs and as many false ones: the frame
/// of one pair with the second frame of another that lies elsewhere. Chosen by `seed`.
void add_pairs(const cv::Mat1b& first, const cv::Mat1b& second, std::vector<FramePair> pairs,
               std::size_t most, std::uint64_t seed, PatchSet& set);

}  // namespace striate::evaluation
