#pragma once

#include <cmath>
#include <cstdint>
#include <opencv2/imgproc.hpp>

#include "tests/unit/perception/obstacles_synthetic_room.hpp"

/// Image pairs of the rooms of obstacles_synthetic_room.hpp: every surface has a random texture
/// that is fixed to it.
namespace striate::perception::synthetic {

/// Smooth noise 0..1 with features of about `size_m`.
inline double texture_at(Vec p, double size_m) {
  const auto cell = [&](double a) { return std::floor(a / size_m); };
  const auto value = [](double x, double y, double z) {
    return 0.5 + 0.5 * noise(static_cast<std::uint64_t>(static_cast<std::int64_t>(x) * 73856093 ^
                                                        static_cast<std::int64_t>(y) * 19349663 ^
                                                        static_cast<std::int64_t>(z) * 83492791));
  };
  const double x = cell(p.x), y = cell(p.y), z = cell(p.z);
  const double a = p.x / size_m - x, b = p.y / size_m - y, c = p.z / size_m - z;
  double sum = 0.0;
  for (int k = 0; k < 8; ++k) {
    const int i = k & 1, j = k >> 1 & 1, l = k >> 2;
    sum += (i != 0 ? a : 1 - a) * (j != 0 ? b : 1 - b) * (l != 0 ? c : 1 - c) *
           value(x + i, y + j, z + l);
  }
  return sum;
}

struct Picture {
  double noisy = 2.0;        ///< grey levels of 255
  double contrast = 140.0;   ///< grey levels between the darkest and the brightest of a surface
  double blank_above_m = 9;  ///< what of a box is higher is painted white, without any texture
};

inline double grey_of(const Room& room, Vec p, const Picture& picture) {
  for (const Box& b : room.boxes) {
    const bool on_it = p.x > b.x0_m - 1e-6 && p.x < b.x1_m + 1e-6 && p.y > b.y0_m - 1e-6 &&
                       p.y < b.y1_m + 1e-6 && p.z < b.z1_m + 1e-6;
    if (on_it && b.z1_m < 1.5 && p.z > picture.blank_above_m) {
      return p.z > b.z1_m - 1e-6 ? 190.0 : 140.0;  // lamps are above
    }
  }
  return picture.contrast * (0.6 * texture_at(p, 0.03) + 0.4 * texture_at(p, 0.10));
}

/// What an eye sees `aside_m` to the left of the pan axis.
inline cv::Mat3b paint(const Room& room, const HeadPose& head, double aside_m,
                       const Picture& picture) {
  constexpr int kWidth = 320, kHeight = 240, kFold = 2;
  const RobotDescription robot;
  const double focal_px = 203.0 * kWidth / 160.0;
  const double cp = std::cos(head.pan_rad), sp = std::sin(head.pan_rad);
  const double ct = std::cos(head.tilt_rad), st = std::sin(head.tilt_rad);
  const Vec eye{robot.camera_forward_m - sp * aside_m, cp * aside_m, robot.camera_height_m};
  cv::Mat3b image(kHeight, kWidth);
  for (int v = 0; v < kHeight; ++v) {
    for (int u = 0; u < kWidth; ++u) {
      double sum = 0.0;
      for (int k = 0; k < kFold * kFold; ++k) {
        const double right = (u + (k % kFold + 0.5) / kFold - 0.5 * kWidth) / focal_px;
        const double down = (v + (k / kFold + 0.5) / kFold - 0.5 * kHeight) / focal_px;
        const double forward = ct + down * st;
        const Vec ray{forward * cp + right * sp, forward * sp - right * cp, st - down * ct};
        const double t = cast(room, eye, ray);
        const Vec p{eye.x + t * ray.x, eye.y + t * ray.y, eye.z + t * ray.z};
        sum += t > 1e8 ? 70.0 : grey_of(room, p, picture);
      }
      const auto counter =
          static_cast<std::uint64_t>((aside_m > 0.0 ? 1 : 2) * 1000003 + v * 4096 + u);
      const double grey = 50.0 + sum / (kFold * kFold) + picture.noisy * noise(counter);
      image(v, u) = cv::Vec3b::all(cv::saturate_cast<uchar>(grey));
    }
  }
  return image;
}

/// The pair that the default robot's eyes see.
inline StereoFrame photograph(const Room& room, const HeadPose& head, const Picture& picture = {}) {
  StereoFrame frame;
  frame.left = paint(room, head, 0.06, picture);
  frame.right = paint(room, head, -0.06, picture);
  frame.focal_px = 203.0 * 2.0;
  frame.centre_u_px = 159.5;
  frame.centre_v_px = 119.5;
  frame.baseline_m = 0.12;
  frame.head = head;
  return frame;
}

}  // namespace striate::perception::synthetic
