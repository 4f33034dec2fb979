#pragma once

#include <opencv2/core.hpp>
#include <utility>
#include <vector>

#include "striate/platform/datasets/calibration/camera_model.hpp"

/// The pinhole camera that both rectified eyes share.
namespace striate::datasets {

/// An eye and how it was turned by rectification.
struct TurnedEye {
  const EyeModel* eye;
  cv::Matx33d turn;
};

[[nodiscard]] cv::Matx33d pinhole_of(double focal_px, cv::Point2d middle, cv::Size size);

/// The shortest focal length at which every pixel was seen by all eyes.
[[nodiscard]] double widest_focal_px(const std::vector<TurnedEye>& eyes, cv::Point2d middle,
                                     cv::Size size);

/// Both eyes turned half of the way, then the baseline laid along x (Bouguet's way).
[[nodiscard]] std::pair<cv::Matx33d, cv::Matx33d> side_by_side(const EyesApart& apart);

}  // namespace striate::datasets
