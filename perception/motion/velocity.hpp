#pragma once

#include <opencv2/core/mat.hpp>
#include <optional>
#include <vector>

#include "striate/base/geometry.hpp"
#include "striate/perception/motion/carried_back.hpp"
#include "striate/perception/percept.hpp"

namespace striate::perception {

/// A pixel of a moving thing: where it is now, in the image and in the robot frame.
struct ThingPixel {
  int u = 0;
  int v = 0;
  SpacePoint at;
};

/// The earlier image and its disparity.
struct EarlierView {
  const cv::Mat1b& grey;
  const DisparityMap& disparity;
  double seconds = 0.0;  ///< ago
};

/// Velocity over the floor (x forward, y left, in the robot frame of now; m/s) of the pixels, which
/// were not where they are now: of all velocities up to `fastest_m_s` in each axis the one that
/// explains their grey in the earlier image best, then corrected by the distance that was
/// measured there. Nothing where no velocity explains them clearly better than most.
[[nodiscard]] std::optional<Point2> find_velocity(const std::vector<ThingPixel>& pixels,
                                                  const cv::Mat1b& grey, const CarriedBack& carried,
                                                  const EarlierView& before, double fastest_m_s);

}  // namespace striate::perception
