#pragma once

#include <optional>
#include <vector>

#include "perception/motion/carried_back.hpp"
#include "perception/motion/motion.hpp"

namespace striate {

/// A pixel of a moving thing: where it is now, in the picture and in the robot frame.
struct ThingPixel {
  int u = 0;
  int v = 0;
  SpacePoint at;
};

/// The earlier picture and its disparity.
struct EarlierView {
  const cv::Mat1b& grey;
  const DisparityMap& disparity;
  double seconds = 0.0;  ///< ago
};

/// Velocity over the floor (x forward, y left, in the robot frame of now; m/s) of the pixels, which
/// were not where they are now: of all velocities up to `fastest_m_s` in each axis the one that
/// explains their grey in the earlier picture best, then corrected by the distance that was
/// measured there. Nothing where no velocity explains them clearly better than most.
[[nodiscard]] std::optional<Point2> find_velocity(const std::vector<ThingPixel>& pixels,
                                                  const cv::Mat1b& grey, const CarriedBack& carried,
                                                  const EarlierView& before, double fastest_m_s);

}  // namespace striate
