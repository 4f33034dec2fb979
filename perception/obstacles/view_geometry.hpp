#pragma once

#include <optional>

#include "striate/perception/percept.hpp"
#include "striate/platform/interface/robot.hpp"
#include "striate/platform/interface/senses.hpp"

namespace striate::perception {

/// A point in the robot frame: x forward and y left of the axle's middle, z above the floor.
struct SpacePoint {
  double x_m = 0.0;
  double y_m = 0.0;
  double z_m = 0.0;
};

/// A pixel of the left image and its disparity.
struct ImagePoint {
  double u_px = 0.0;
  double v_px = 0.0;
  double d_px = 0.0;
};

/// Where the pixels of the left image lie in the robot's world, for one pose of the head.
///
/// With tilt t (up positive), y = (v - centre_v) / f and a camera h above the floor:
///
///     floor line            d(v) = f B (y cos t - sin t) / h         (negative above the horizon)
///     height of a pixel     z    = h (1 - d(v) / d)
///     level disparity       e    = d / (cos t + y sin t) = f B / forward distance
///
/// The level disparity is what a camera that looks straight ahead would measure: every vertical
/// surface has one value of it down a column, whatever the tilt. The left camera sits half a
/// baseline to the left of the pan axis; the head does not roll.
class ViewGeometry {
 public:
  ViewGeometry(const DisparityMap& map, const HeadPose& head, const RobotDescription& robot);

  /// Disparity of the floor in row v; negative above the horizon.
  [[nodiscard]] double floor_disparity_px(double v_px) const {
    return floor_slope_ * (v_px - centre_v_px_) + floor_at_centre_px_;
  }
  /// Factor that turns a disparity of row v into a level disparity.
  [[nodiscard]] double level_factor(double v_px) const {
    return 1.0 / (cos_tilt_ + (v_px - centre_v_px_) / focal_px_ * sin_tilt_);
  }
  /// Metres that the line of sight of row v falls in each metre forward; negative where it rises.
  /// It meets the floor h over that ahead of the camera.
  [[nodiscard]] double fall_of_row(double v_px) const {
    const double y = (v_px - centre_v_px_) / focal_px_;
    return (y * cos_tilt_ - sin_tilt_) / (cos_tilt_ + y * sin_tilt_);
  }
  /// Height above the floor of what has disparity `d_px` > 0 in row v.
  [[nodiscard]] double height_m(double v_px, double d_px) const {
    return camera_height_m_ * (1.0 - floor_disparity_px(v_px) / d_px);
  }
  /// Row of the horizon: everything at the camera's height appears there.
  [[nodiscard]] double horizon_v_px() const {
    return centre_v_px_ - floor_at_centre_px_ / floor_slope_;
  }
  [[nodiscard]] SpacePoint point(double u_px, double v_px, double d_px) const;
  /// The inverse of point(): where it appears. Nothing behind the camera.
  [[nodiscard]] std::optional<ImagePoint> project(const SpacePoint& point) const;
  /// Direction of column u where level disparities are measured (the horizon's row).
  [[nodiscard]] double ray_bearing_rad(double u_px) const;
  /// The floor plan's point of column u at level disparity `e_px`.
  [[nodiscard]] Point2 level_point(double u_px, double e_px) const;

  [[nodiscard]] double focal_baseline() const { return focal_baseline_; }
  [[nodiscard]] double focal_px() const { return focal_px_; }
  [[nodiscard]] double centre_u_px() const { return centre_u_px_; }
  [[nodiscard]] double camera_height_m() const { return camera_height_m_; }

 private:
  [[nodiscard]] Point2 from_head(double forward_m, double left_m) const;

  double focal_px_;
  double centre_u_px_;
  double centre_v_px_;
  double focal_baseline_;  ///< f B, in px m
  double half_baseline_m_;
  double camera_height_m_;
  double camera_forward_m_;
  double cos_pan_;
  double sin_pan_;
  double pan_rad_;
  double cos_tilt_;
  double sin_tilt_;
  double floor_slope_;
  double floor_at_centre_px_;
};

}  // namespace striate::perception
