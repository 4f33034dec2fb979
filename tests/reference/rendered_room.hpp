#pragma once

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>
#include <vector>

#include "striate/perception/visual_odometry/rigid_motion.hpp"
#include "striate/perception/visual_odometry/stereo_eyes.hpp"
#include "tests/reference/test_images.hpp"

/// A room with textured walls and pillars as a stereo camera sees it, made by rule: every pixel's
/// ray is followed to what it meets, so the camera's motion is known exactly.
namespace striate::reference {

/// Smooth noise, -1..1, with lattice points 1 apart.
inline double smooth_noise(double x, double y, int seed) {
  const double left = std::floor(x), top = std::floor(y);
  const auto at = [&](int dx, int dy) {
    return hash_noise(static_cast<int>(left) + dx, static_cast<int>(top) + dy, seed) / 32767.5 -
           1.0;
  };
  const auto eased = [](double t) { return t * t * (3.0 - 2.0 * t); };
  const double a = eased(x - left), b = eased(y - top);
  return (1 - b) * ((1 - a) * at(0, 0) + a * at(1, 0)) + b * ((1 - a) * at(0, 1) + a * at(1, 1));
}

/// An upright box, in the room's axes: x right, y down, z forward.
struct RoomBox {
  cv::Vec3d low, high;
  int seed = 0;
};

class RenderedRoom {
 public:
  double contrast = 70.0;  ///< grey levels either way; 0: blank
  double light = 1.0;      ///< factor of every grey
  double noise = 0.0;      ///< standard deviation of a pixel
  std::vector<RoomBox> boxes = {{{-1.6, -0.4, 4.0}, {-1.0, 1.2, 4.6}, 11},
                                {{1.1, 0.1, 3.0}, {1.6, 1.2, 3.5}, 12},
                                {{-0.2, -1.4, 7.5}, {0.3, 1.2, 8.0}, 13}};

  /// @param seed of the noise
  [[nodiscard]] perception::StereoView see(const perception::RigidMotion& world_from_camera,
                                           cv::Size size, int seed = 1) const {
    perception::StereoView view;
    view.eyes = {0.85 * size.width, 0.5 * (size.width - 1), 0.5 * (size.height - 1), 0.12, 0.0};
    view.left = eye(world_from_camera, view.eyes, size, 0.0, 2 * seed);
    view.right = eye(world_from_camera, view.eyes, size, view.eyes.baseline_m, 2 * seed + 1);
    return view;
  }

 private:
  [[nodiscard]] cv::Mat1b eye(const perception::RigidMotion& pose,
                              const perception::StereoEyes& eyes, cv::Size size, double right_m,
                              int seed) const {
    cv::Mat1b image(size);
    const cv::Vec3d from = pose * cv::Vec3d(right_m, 0, 0);
    for (int v = 0; v < size.height; ++v) {
      for (int u = 0; u < size.width; ++u) {
        double sum = 0.0;
        for (const double off : {-0.25, 0.25}) {
          const cv::Vec3d ray((u + off - eyes.centre_u_px) / eyes.focal_px,
                              (v + off - eyes.centre_v_px) / eyes.focal_px, 1.0);
          sum += 0.5 * grey_along(from, pose.rotation * ray);
        }
        image(v, u) = cv::saturate_cast<std::uint8_t>(light * sum);
      }
    }
    return noise > 0.0 ? with_noise(image, noise, seed) : image;
  }

  [[nodiscard]] double grey_along(const cv::Vec3d& from, const cv::Vec3d& ray) const {
    // The room itself is a box that is seen from inside.
    const RoomBox room{{-3.0, -1.5, -4.0}, {3.0, 1.2, 14.0}, 1};
    double nearest = 1e9, grey = 0.0;
    meet(room, from, ray, false, nearest, grey);
    for (const RoomBox& box : boxes) meet(box, from, ray, true, nearest, grey);
    return grey;
  }

  void meet(const RoomBox& box, const cv::Vec3d& from, const cv::Vec3d& ray, bool outside,
            double& nearest, double& grey) const {
    double enter = -1e9, leave = 1e9;
    int enter_axis = 0, leave_axis = 0;
    for (int axis = 0; axis < 3; ++axis) {
      if (std::abs(ray[axis]) < 1e-12) {
        if (from[axis] < box.low[axis] || from[axis] > box.high[axis]) return;
        continue;
      }
      const double a = (box.low[axis] - from[axis]) / ray[axis];
      const double b = (box.high[axis] - from[axis]) / ray[axis];
      if (std::min(a, b) > enter) enter = std::min(a, b), enter_axis = axis;
      if (std::max(a, b) < leave) leave = std::max(a, b), leave_axis = axis;
    }
    const double along = outside ? enter : leave;
    if (enter > leave || along <= 1e-3 || along >= nearest) return;
    nearest = along;
    grey = painted(from + along * ray, outside ? enter_axis : leave_axis, box.seed);
  }

  /// Grains from 4 to 60 cm.
  [[nodiscard]] double painted(const cv::Vec3d& point, int axis, int seed) const {
    const double x = point[(axis + 1) % 3], y = point[(axis + 2) % 3];
    double sum = 0.0;
    for (const double grain_m : {0.04, 0.1, 0.25, 0.6}) {
      sum += smooth_noise(x / grain_m, y / grain_m,
                          seed * 31 + axis * 7 + static_cast<int>(grain_m * 100));
    }
    return 120.0 + contrast * 0.7 * sum;
  }
};

/// Another picture of the same moment.
inline perception::StereoView with_noise(perception::StereoView view, double sigma, int seed) {
  view.left = with_noise(cv::Mat1b(view.left), sigma, 2 * seed);
  view.right = with_noise(cv::Mat1b(view.right), sigma, 2 * seed + 1);
  return view;
}

/// A pose by where it is and how it is turned.
inline perception::RigidMotion room_pose(const cv::Vec3d& place_m, const cv::Vec3d& turn_rad = {}) {
  return {perception::rotation_about(turn_rad), place_m};
}

}  // namespace striate::reference
