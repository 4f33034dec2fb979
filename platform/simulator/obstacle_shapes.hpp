#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "striate/platform/simulator/world.hpp"

/// How large each kind of obstacle is and what it covers of the floor: one truth for the renderer,
/// which draws it, and for the physics, which lets the robot touch it. Frame of an obstacle: its
/// middle on the floor, x along its `turn_rad`, y to the left, z up.
namespace striate::simulator {

struct ObstacleSize {
  double x_m = 0.0;
  double y_m = 0.0;
  double z_m = 0.0;  ///< of the whole thing, chair back and top box included
};

/// A convex polygon, counter-clockwise, at most eight corners (Box2D's limit).
using Footprint = std::vector<Point2>;

[[nodiscard]] inline ObstacleSize default_size(ObstacleKind kind) {
  switch (kind) {
    case ObstacleKind::table:
      return {1.2, 0.7, 0.74};
    case ObstacleKind::chair:
      return {0.48, 0.48, 0.88};
    case ObstacleKind::cardboard_box:
      return {0.5, 0.4, 0.4};
    case ObstacleKind::styrofoam_box:
      return {0.4, 0.4, 0.8};
    case ObstacleKind::box:
      return {0.5, 0.5, 0.6};
    case ObstacleKind::cylinder:
      return {0.4, 0.4, 0.9};
    case ObstacleKind::plant:
      return {0.6, 0.6, 1.3};
    case ObstacleKind::bin:
      return {0.36, 0.36, 0.6};
    case ObstacleKind::wall:
      return {1.0, 0.2, 2.7};
    case ObstacleKind::glass:
      return {1.0, 0.05, 2.05};
    case ObstacleKind::stairs:
      return {1.8, 1.2, 1.4};
    case ObstacleKind::sitter:
      return {0.76, 0.5, 1.28};
  }
  return {};
}

/// Of a glass pane's frame: posts at its two ends, as wide as this.
inline constexpr double kGlassPost_m = 0.05;

/// The size of this very obstacle: what the world says, else the kind's own.
[[nodiscard]] inline ObstacleSize size_of(const WorldObstacle& obstacle) {
  ObstacleSize size = default_size(obstacle.kind);
  if (obstacle.size_x_m > 0.0) size.x_m = obstacle.size_x_m;
  if (obstacle.size_y_m > 0.0) size.y_m = obstacle.size_y_m;
  if (obstacle.size_z_m > 0.0) size.z_m = obstacle.size_z_m;
  return size;
}

/// Cardboard boxes taller than this are drawn as a stack of two.
inline constexpr double kStackAbove_m = 0.7;

/// Book, box and cup where the world gives no size.
[[nodiscard]] inline ObstacleSize size_of(const WorldObject& object) {
  ObstacleSize size{0.24, 0.16, 0.16};
  if (object.kind == "book") size = {0.17, 0.035, 0.24};
  if (object.kind == "cup") size = {0.085, 0.085, 0.10};
  if (object.size_x_m > 0.0) size.x_m = object.size_x_m;
  if (object.size_y_m > 0.0) size.y_m = object.size_y_m;
  if (object.size_z_m > 0.0) size.z_m = object.size_z_m;
  return size;
}

/// A person takes this radius on the floor, arms and a step included.
inline constexpr double kPersonRadius_m = 0.25;
/// A person, and 2 cm that a walker's steps err by (ours)
inline constexpr double kPersonRoom_m = kPersonRadius_m + 0.02;
/// A grown-up (ours); the wardrobe's heights are shares of it
inline constexpr double kPersonHeight_m = 1.78;

[[nodiscard]] inline Footprint rectangle_footprint(double x_m, double y_m) {
  const double a = x_m / 2.0;
  const double b = y_m / 2.0;
  return {{-a, -b}, {a, -b}, {a, b}, {-a, b}};
}

/// An octagon around the ellipse: its sides touch it, so that nothing round sticks out.
[[nodiscard]] inline Footprint round_footprint(double x_m, double y_m) {
  Footprint polygon;
  const double reach = 0.5 / std::cos(std::numbers::pi / 8.0);
  for (int i = 0; i < 8; ++i) {
    const double angle = (i + 0.5) * std::numbers::pi / 4.0;
    polygon.push_back({reach * x_m * std::cos(angle), reach * y_m * std::sin(angle)});
  }
  return polygon;
}

/// What a robot with a tall mast can bump into, seen from above, in the obstacle's frame. A
/// table's is its whole top, a plant's its pot and foliage.
[[nodiscard]] inline std::vector<Footprint> footprint(const WorldObstacle& obstacle) {
  const ObstacleSize size = size_of(obstacle);
  switch (obstacle.kind) {
    case ObstacleKind::cylinder:
    case ObstacleKind::plant:
    case ObstacleKind::bin:
      return {round_footprint(size.x_m, size.y_m)};
    default:
      return {rectangle_footprint(size.x_m, size.y_m)};
  }
}

}  // namespace striate::simulator
