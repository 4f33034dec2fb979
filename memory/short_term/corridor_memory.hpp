#pragma once

#include <cstdint>

#include "striate/memory/short_term/wall_fit.hpp"
#include "striate/perception/percept.hpp"

namespace striate::memory {

/// The corridor as remembered: its axis as a heading in the odometry frame, the robot's place
/// across it, and its width. Slow scalar Kalman filters with gates: one odd image changes
/// nothing, the drift of the odometry is followed. Where nothing is seen the odometry carries on.
/// The heading at the start is the first estimate.
class CorridorMemory {
 public:
  /// Starts anew with the robot standing along the axis in the middle.
  void start(const Pose2& robot);
  [[nodiscard]] bool started() const { return started_; }

  /// The robot has moved on; drift adds to the uncertainty.
  void move(const Pose2& before, const Pose2& after);

  /// A image's view of the corridor, seen from `at`; `now` is where the robot is by now.
  void see(const perception::CorridorView& view, const Pose2& at, const Pose2& now);

  /// The walls as the map remembers them, measured from where the robot is now.
  enum class Source : std::uint8_t { things, edges };
  void see(const WallFit& fit, Source source);

  [[nodiscard]] double axis_rad() const { return axis_.value; }  ///< in the odometry frame
  [[nodiscard]] double axis_std_rad() const;
  /// Of the robot from the middle, to the left, along the axis' normal.
  [[nodiscard]] double offset_m() const { return offset_.value; }
  [[nodiscard]] double offset_std_m() const;
  [[nodiscard]] double width_m() const { return width_m_; }
  [[nodiscard]] bool width_known() const { return width_looks_ >= kWidthLooks; }
  /// Path along the axis since the start.
  [[nodiscard]] double progress_m() const { return progress_m_; }
  /// Distances of the walls; kNothing_m while they were not seen for some metres.
  [[nodiscard]] double left_m() const {
    return left_.known() ? left_.distance_m : perception::kNothing_m;
  }
  [[nodiscard]] double right_m() const {
    return right_.known() ? right_.distance_m : perception::kNothing_m;
  }

 private:
  static constexpr int kWidthLooks = 3;         ///< by hand: one or two may be wrong
  static constexpr double kRemembered_m = 4.0;  ///< by hand: longer than a door
  static constexpr double kFirstWidth_m = 2.4;  ///< of the shipped corridors, until it is known
  struct Estimate {
    double value = 0.0;
    double variance = 0.0;
    int rejected = 0;  ///< outliers in a row
    bool take(double innovation, double variance_seen, double least_gate, int patience);
  };
  struct Wall {
    double distance_m = 0.0;
    double unseen_m = 1e9;  ///< way since it was last seen
    [[nodiscard]] bool known() const { return unseen_m < kRemembered_m; }
    void see(double seen_m);
  };
  void see_heading(double heading_rad, double std_rad);
  void see_walls(double left_m, double right_m, double std_m);

  bool started_ = false;
  Estimate axis_;
  Estimate offset_;
  Wall left_;
  Wall right_;
  double width_m_ = kFirstWidth_m;
  int width_looks_ = 0;
  double progress_m_ = 0.0;
};

}  // namespace striate::memory
