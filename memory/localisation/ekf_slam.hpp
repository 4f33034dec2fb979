#pragma once

#include <cstddef>
#include <vector>

#include "striate/base/geometry.hpp"
#include "striate/memory/localisation/localisation_settings.hpp"
#include "striate/memory/localisation/slam_types.hpp"
#include "striate/memory/long_term/records.hpp"

namespace striate::memory {

/// The extended Kalman filter of EKF-SLAM (Smith, Self and Cheeseman 1990): one Gaussian over the
/// robot's pose, the three errors of its odometry that stay the same over a run (scale of ways,
/// scale of turns, drift), and the places of up to kLandmarks landmarks. Landmarks are numbered
/// 0 .. size() - 1. Allocates in `start` alone.
class EkfSlam {
 public:
  static constexpr int kLandmarks = slam_state::kLandmarks;  ///< at most
  static constexpr int kRobot = slam_state::kRobot;          ///< states of the robot itself

  explicit EkfSlam(const LocalisationSettings& settings) : settings_(settings) {}

  /// Stands at `pose` for sure; no landmarks.
  void start(const Pose2& pose);
  /// @param step as the odometry says, in the robot's frame before it
  void predict(const Pose2& step);

  /// Where a landmark was seen: a point of the robot's frame now, with covariance.
  using Seen = MapPosition;
  /// A new landmark where it was seen. @return its number; -1: there is no room
  int add_seen(const Seen& seen);
  /// A new landmark that is known from elsewhere. @return its number; -1: there is no room
  int add_known(const MapPosition& place);
  /// The landmark of the last number gets this number.
  void remove(int landmark);

  /// Squared Mahalanobis distance of a sighting from what is expected.
  [[nodiscard]] double distance2(int landmark, const Seen& seen) const;
  void update(int landmark, const Seen& seen);
  /// The same for a sighting without a range.
  using SeenBearing = memory::SeenBearing;
  [[nodiscard]] double distance2(int landmark, const SeenBearing& seen) const;
  void update(int landmark, const SeenBearing& seen);
  /// The same for a place that is known from elsewhere.
  [[nodiscard]] double distance2_to(int landmark, const MapPosition& known) const;
  void fuse(int landmark, const MapPosition& known);

  /// Puts all into another frame, whose place is known with covariance: x' = frame o x.
  void change_frame(const Pose2& frame, const PoseCovariance& covariance);

  [[nodiscard]] int size() const { return landmarks_; }
  [[nodiscard]] Pose2 pose() const { return {state_[0], state_[1], state_[2]}; }
  [[nodiscard]] PoseCovariance pose_covariance() const;
  [[nodiscard]] MapPosition place(int landmark) const;
  /// The place of a landmark with its covariance relative to the robot's position.
  [[nodiscard]] MapPosition place_from_robot(int landmark) const;
  /// Adds the covariance of the robot's position to a place that is known from elsewhere.
  [[nodiscard]] MapPosition from_robot(const MapPosition& known) const;

 private:
  [[nodiscard]] int used() const { return kRobot + 2 * landmarks_; }
  [[nodiscard]] static int row_of(int landmark) { return kRobot + 2 * landmark; }

  LocalisationSettings settings_;
  int landmarks_ = 0;
  std::vector<double> state_ = std::vector<double>(kRobot, 0.0);
  std::vector<double> covariance_;  ///< square, kRobot + 2 kLandmarks wide
  std::vector<double> gain_;        ///< two columns
};

}  // namespace striate::memory
