#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "striate/platform/interface/senses.hpp"
#include "striate/platform/simulator/world.hpp"

/// What renderer, physics and judge share: the flat floor plan and where everybody stands now.
namespace striate::simulator {

/// A vertical stretch of wall in the flat plan. Free space lies to the left of from -> to.
struct WallSegment {
  Point2 from;
  Point2 to;
  double bottom_m = 0.0;
  double top_m = 2.7;
  std::string material;
  Side side = Side::left;
  double along_m = 0.0;  ///< corridor coordinate of `from`, for textures that run on
};

/// The corridor in the flat plan (for a straight corridor the same coordinates as the world file).
struct FloorPlan {
  std::vector<WallSegment> walls;   ///< closed outline, end walls included
  std::vector<Point2> outline;      ///< the same outline as a polygon, counter-clockwise
  std::vector<Point2> centre_line;  ///< first point: the middle of the start wall
  double height_m = 2.7;

  /// Corridor coordinates (along, left) to the plan, and the corridor's direction there.
  [[nodiscard]] Pose2 at(double along_m, double left_m) const;
  /// The inverse: x_m along, y_m left of the centre line, heading relative to the corridor.
  [[nodiscard]] Pose2 along(const Pose2& plan) const;
};

/// Implemented in floor_plan.cpp.
[[nodiscard]] FloorPlan build_floor_plan(const World& world);

/// One person at one moment, in the plan.
struct PersonState {
  int look = 0;  ///< which of the clothes sets; >= 0
  Pose2 pose;
  double stride_rad = 0.0;  ///< phase of the walk; legs together at 0
  double speed_m_s = 0.0;
  bool carries = false;  ///< a box before the chest, within the disc that a person is
};

/// Everything that moves, at one moment. Coordinates of the plan.
struct SceneState {
  double time_s = 0.0;
  Pose2 robot;               ///< true pose of the axle
  double forward_m_s = 0.0;  ///< true, for motion blur
  double turn_rad_s = 0.0;
  HeadPose head;  ///< true
  std::vector<PersonState> people;
  std::vector<std::size_t> absent;  ///< obstacles of the world that are not there yet
  std::uint64_t frame = 0;          ///< counts images: noise of frame n is always the same
};

}  // namespace striate::simulator
