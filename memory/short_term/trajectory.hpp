#pragma once

#include <array>
#include <cstddef>

#include "striate/base/geometry.hpp"

namespace striate::memory {

/// Where the robot has been in this run: breadcrumbs in the odometry frame, the start first. Fixed
/// memory: when it is full every second crumb is dropped and the step is doubled, so the trail
/// never ends, it only becomes coarser.
class Trajectory {
 public:
  static constexpr std::size_t kCapacity = 512;  ///< crumbs: 128 m, the corridor there and back
  static constexpr double kFirstStep_m = 0.25;   ///< by hand: half the robot's length

  /// The robot is here now.
  void walk(const Pose2& here);

  [[nodiscard]] std::size_t count() const { return count_; }
  [[nodiscard]] Point2 at(std::size_t i) const { return crumbs_[i]; }
  [[nodiscard]] double step_m() const { return step_m_; }  ///< between two crumbs, at least
  [[nodiscard]] const Pose2& start() const { return start_; }
  /// The crumb nearest to a place; 0 on an empty trail.
  [[nodiscard]] std::size_t nearest(Point2 place) const;
  /// Distance of a place from the nearest crumb that is older than the last `skipped`; infinity
  /// where there is none.
  [[nodiscard]] double distance_m(Point2 place, std::size_t skipped = 0) const;

 private:
  void thin();

  std::array<Point2, kCapacity> crumbs_{};
  std::size_t count_ = 0;
  double step_m_ = kFirstStep_m;
  Pose2 start_;
};

}  // namespace striate::memory
