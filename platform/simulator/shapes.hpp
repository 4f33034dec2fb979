#pragma once

#include <vector>

#include "striate/base/geometry.hpp"
#include "striate/platform/interface/robot.hpp"

/// Flat convex shapes and the exact distance between them: who stands where, and how near.
namespace striate::simulator {

/// A convex polygon (corners counter-clockwise) grown by a radius. One corner: a disc. Two: a
/// rounded line.
struct ConvexShape {
  std::vector<Point2> corners;
  double radius_m = 0.0;
};

/// The body's octagon seen from the middle of its axle: a rectangle whose corners are cut.
[[nodiscard]] ConvexShape robot_footprint(const RobotDescription& robot);

[[nodiscard]] ConvexShape disc(Point2 middle, double radius_m);
[[nodiscard]] ConvexShape rectangle(const Pose2& middle, double size_x_m, double size_y_m);

/// The shape moved from the frame of `pose` to the frame that `pose` is given in.
[[nodiscard]] ConvexShape moved(const ConvexShape& shape, const Pose2& pose);

/// Smallest distance between two shapes; 0 where they touch or overlap.
[[nodiscard]] double distance_m(const ConvexShape& a, const ConvexShape& b);

/// A quick lower bound of distance_m by bounding circles around the given middles.
[[nodiscard]] double bounding_radius_m(const ConvexShape& shape, Point2 middle);

[[nodiscard]] double distance_m(Point2 a, Point2 b);
[[nodiscard]] double distance_to_segment_m(Point2 p, Point2 from, Point2 to);
/// The point of the segment that is nearest to `p`.
[[nodiscard]] Point2 nearest_on_segment(Point2 p, Point2 from, Point2 to);
[[nodiscard]] bool segments_cross(Point2 a, Point2 b, Point2 c, Point2 d);
[[nodiscard]] bool inside_polygon(Point2 p, const std::vector<Point2>& polygon);

}  // namespace striate::simulator
