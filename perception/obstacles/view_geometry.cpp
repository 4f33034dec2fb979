#include "striate/perception/obstacles/view_geometry.hpp"

#include <cmath>

namespace striate::perception {

ViewGeometry::ViewGeometry(const DisparityMap& map, const HeadPose& head,
                           const RobotDescription& robot)
    : focal_px_(map.focal_px),
      centre_u_px_(map.centre_u_px),
      centre_v_px_(map.centre_v_px),
      focal_baseline_(map.focal_px * map.baseline_m),
      half_baseline_m_(0.5 * map.baseline_m),
      camera_height_m_(robot.camera_height_m),
      camera_forward_m_(robot.camera_forward_m),
      cos_pan_(std::cos(head.pan_rad)),
      sin_pan_(std::sin(head.pan_rad)),
      pan_rad_(head.pan_rad),
      cos_tilt_(std::cos(head.tilt_rad)),
      sin_tilt_(std::sin(head.tilt_rad)),
      floor_slope_(map.baseline_m * cos_tilt_ / camera_height_m_),
      floor_at_centre_px_(-focal_baseline_ * sin_tilt_ / camera_height_m_) {}

Point2 ViewGeometry::from_head(double forward_m, double left_m) const {
  const double y = left_m + half_baseline_m_;
  return {camera_forward_m_ + forward_m * cos_pan_ - y * sin_pan_,
          forward_m * sin_pan_ + y * cos_pan_};
}

SpacePoint ViewGeometry::point(double u_px, double v_px, double d_px) const {
  const double depth_m = focal_baseline_ / d_px;
  const double y = (v_px - centre_v_px_) / focal_px_;
  const Point2 floor = from_head(depth_m * (cos_tilt_ + y * sin_tilt_),
                                 -depth_m * (u_px - centre_u_px_) / focal_px_);
  return {floor.x_m, floor.y_m, camera_height_m_ + depth_m * (sin_tilt_ - y * cos_tilt_)};
}

std::optional<ImagePoint> ViewGeometry::project(const SpacePoint& point) const {
  // Depth before the camera; nearer, the projection grows without bound (4000 px a metre)
  constexpr double kNearest_m = 0.05;
  const double x = point.x_m - camera_forward_m_;
  const double forward_m = x * cos_pan_ + point.y_m * sin_pan_;
  const double left_m = point.y_m * cos_pan_ - x * sin_pan_ - half_baseline_m_;
  const double up_m = point.z_m - camera_height_m_;
  const double depth_m = forward_m * cos_tilt_ + up_m * sin_tilt_;
  if (depth_m < kNearest_m) return std::nullopt;
  const double down_m = forward_m * sin_tilt_ - up_m * cos_tilt_;
  return ImagePoint{centre_u_px_ - focal_px_ * left_m / depth_m,
                    centre_v_px_ + focal_px_ * down_m / depth_m, focal_baseline_ / depth_m};
}

double ViewGeometry::ray_bearing_rad(double u_px) const {
  return pan_rad_ - std::atan((u_px - centre_u_px_) / focal_px_ * cos_tilt_);
}

Point2 ViewGeometry::level_point(double u_px, double e_px) const {
  // On the horizon's row cos t + y sin t = 1 / cos t, so left / forward = -x cos t.
  const double forward_m = focal_baseline_ / e_px;
  return from_head(forward_m, -forward_m * (u_px - centre_u_px_) / focal_px_ * cos_tilt_);
}

}  // namespace striate::perception
