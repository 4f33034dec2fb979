#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "striate/perception/percept.hpp"
#include "striate/platform/interface/robot.hpp"
#include "striate/platform/interface/senses.hpp"

/// Exact disparity maps of a floor, upright walls and boxes, by ray casting: what a perfect matcher
/// would hand to the obstacle finder. Written apart from ViewGeometry, so that each checks the
/// other.
namespace striate::perception::synthetic {

struct Box {  ///< axis-parallel, in the robot frame
  double x0_m, x1_m, y0_m, y1_m, z0_m, z1_m;
};

struct Room {
  std::vector<Box> boxes;
  bool floor = true;
  double left_m = 1.2;  ///< walls of the corridor, seen from the robot; turned by `heading_rad`
  double right_m = 1.2;
  double heading_rad = 0.0;
  bool walls = true;
  double height_m = 2.7;
};

struct Vec {
  double x, y, z;
};

/// Counter-based noise, uniform in -1 .. 1.
inline double noise(std::uint64_t counter) {
  std::uint64_t z = (counter + 1) * 0x9E3779B97F4A7C15ULL;
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ULL;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBULL;
  z ^= z >> 31;
  return static_cast<double>(z >> 11) * (2.0 / 9007199254740992.0) - 1.0;
}

inline std::optional<double> hit_box(Vec o, Vec d, const Box& b) {
  double t0 = 1e-6;
  double t1 = 1e9;
  const auto slab = [&](double from, double dir, double low, double high) {
    if (std::abs(dir) < 1e-12) return from >= low && from <= high;
    double a = (low - from) / dir;
    double c = (high - from) / dir;
    if (a > c) std::swap(a, c);
    t0 = std::max(t0, a);
    t1 = std::min(t1, c);
    return t0 <= t1;
  };
  if (!slab(o.x, d.x, b.x0_m, b.x1_m) || !slab(o.y, d.y, b.y0_m, b.y1_m) ||
      !slab(o.z, d.z, b.z0_m, b.z1_m)) {
    return std::nullopt;
  }
  return t0;
}

/// Optical depth of what the ray meets first; +inf for nothing.
inline double cast(const Room& room, Vec o, Vec d) {
  double t = 1e9;
  if (room.floor && d.z < 0.0) t = std::min(t, -o.z / d.z);
  if (room.walls) {
    if (d.z > 0.0) t = std::min(t, (room.height_m - o.z) / d.z);
    const double nx = -std::sin(room.heading_rad);
    const double ny = std::cos(room.heading_rad);
    const double offset = nx * o.x + ny * o.y;
    const double speed = nx * d.x + ny * d.y;
    if (speed > 1e-12) t = std::min(t, (room.left_m - offset) / speed);
    if (speed < -1e-12) t = std::min(t, (-room.right_m - offset) / speed);
  }
  for (const Box& b : room.boxes) {
    if (const auto hit = hit_box(o, d, b)) t = std::min(t, *hit);
  }
  return t;
}

inline DisparityMap empty_map(int width = 160, int height = 120) {
  DisparityMap map;
  map.disparity_px = cv::Mat1f(height, width, kNoMatch);
  map.confidence = cv::Mat1f(height, width, 0.0F);
  map.focal_px = 203.0 * width / 160.0;
  map.centre_u_px = 0.5 * (width - 1);
  map.centre_v_px = 0.5 * (height - 1);
  map.baseline_m = 0.12;
  return map;
}

/// `noise_px`: uniform error of the disparity, plus or minus.
inline DisparityMap look(const Room& room, const HeadPose& head, double noise_px = 0.0) {
  DisparityMap map = empty_map();
  const RobotDescription robot;
  const double cp = std::cos(head.pan_rad), sp = std::sin(head.pan_rad);
  const double ct = std::cos(head.tilt_rad), st = std::sin(head.tilt_rad);
  // The left eye, half a baseline to the left of the pan axis.
  const Vec eye{robot.camera_forward_m - sp * 0.5 * map.baseline_m, cp * 0.5 * map.baseline_m,
                robot.camera_height_m};
  for (int v = 0; v < map.disparity_px.rows; ++v) {
    for (int u = 0; u < map.disparity_px.cols; ++u) {
      const double right = (u - map.centre_u_px) / map.focal_px;
      const double down = (v - map.centre_v_px) / map.focal_px;
      const double forward = ct + down * st;  // in the panned frame
      const Vec ray{forward * cp + right * sp, forward * sp - right * cp, st - down * ct};
      const double depth = cast(room, eye, ray);
      if (depth > 1e8) continue;
      const double error = noise_px * noise(static_cast<std::uint64_t>(v) * 4096 + u);
      map.disparity_px(v, u) =
          static_cast<float>(std::max(0.0, map.focal_px * map.baseline_m / depth + error));
      map.confidence(v, u) = 0.9F;
    }
  }
  return map;
}

inline void make_unknown(DisparityMap& map, cv::Rect where) {
  map.disparity_px(where).setTo(kNoMatch);
  map.confidence(where).setTo(0.0F);
}

}  // namespace striate::perception::synthetic
