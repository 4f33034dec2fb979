#pragma once

#include <cmath>
#include <cstddef>
#include <deque>

#include "striate/base/geometry.hpp"

namespace striate::agent {

/// Where the robot believes it has been (odometry frame), oldest first; a point every 10 cm.
class DrawnTrajectory {
 public:
  void add(const Pose2& pose) {
    const bool moved = points_.empty() || std::hypot(pose.x_m - points_.back().x_m,
                                                     pose.y_m - points_.back().y_m) > kStep_m;
    if (!moved) return;
    points_.push_back({pose.x_m, pose.y_m});
    if (points_.size() > kMost) points_.pop_front();
  }
  [[nodiscard]] const std::deque<Point2>& points() const { return points_; }

 private:
  static constexpr double kStep_m = 0.1;     ///< between points: a pixel or two of the drawn map
  static constexpr std::size_t kMost = 400;  ///< points: 40 m, more than the drawn map reaches
  std::deque<Point2> points_;
};

}  // namespace striate::agent
