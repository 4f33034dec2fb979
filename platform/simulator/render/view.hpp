#pragma once

#include "striate/platform/simulator/render/camera_settings.hpp"
#include "striate/platform/simulator/render/vec.hpp"
#include "striate/platform/simulator/scene.hpp"

namespace striate::simulator::render {

/// A pinhole camera in the world. A ray's direction has length one along the optical axis, so
/// that Embree's distance is the depth.
struct View {
  Vec3 origin;
  Vec3 forward;
  Vec3 right;
  Vec3 down;
  int width_px = 0;
  int height_px = 0;
  float focal_px = 0.0F;
  float centre_u_px = 0.0F;
  float centre_v_px = 0.0F;
  /// What is left of the vertical misalignment: offset and its growth across the image.
  float skew_px = 0.0F;
  float skew_by_u = 0.0F;
  float skew_by_v = 0.0F;

  [[nodiscard]] Vec3 ray(float u_px, float v_px) const {
    const float x = u_px - centre_u_px;
    const float y = v_px - centre_v_px;
    const float shifted = y + skew_px + skew_by_u * x + skew_by_v * y;
    return forward + right * (x / focal_px) + down * (shifted / focal_px);
  }
};

enum class Eye { left, right };

/// Left is half a baseline to the left along the head's pan direction; tilt up is positive.
[[nodiscard]] inline View view_of(const SceneState& state, const CameraSettings& camera, Eye eye,
                                  int width_px) {
  const double heading = state.robot.heading_rad + state.head.pan_rad;
  const double c = std::cos(heading);
  const double s = std::sin(heading);
  const double ct = std::cos(state.head.tilt_rad);
  const double st = std::sin(state.head.tilt_rad);
  const Point2 axis = transform(state.robot, Point2{camera.forward_of_axle_m, 0.0});
  const double aside = (eye == Eye::left ? 0.5 : -0.5) * camera.baseline_m;
  const auto f = [](double v) { return static_cast<float>(v); };
  View view;
  view.origin = {f(axis.x_m - s * aside), f(axis.y_m + c * aside), f(camera.height_above_floor_m)};
  view.forward = {f(ct * c), f(ct * s), f(st)};
  view.right = {f(s), f(-c), 0.0F};
  view.down = {f(st * c), f(st * s), f(-ct)};
  view.width_px = width_px;
  view.height_px = width_px * 3 / 4;
  view.focal_px = f(width_px / 2.0 / std::tan(camera.field_rad / 2.0));
  view.centre_u_px = f((view.width_px - 1) / 2.0);
  view.centre_v_px = f((view.height_px - 1) / 2.0);
  return view;
}

}  // namespace striate::simulator::render
