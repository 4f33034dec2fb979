#include "striate/platform/simulator/shapes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace striate::simulator {
namespace {

double cross(Point2 o, Point2 a, Point2 b) {
  return (a.x_m - o.x_m) * (b.y_m - o.y_m) - (a.y_m - o.y_m) * (b.x_m - o.x_m);
}

bool inside_convex(Point2 p, const std::vector<Point2>& corners) {
  if (corners.size() < 3) return false;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (cross(corners[i], corners[(i + 1) % corners.size()], p) < 0.0) return false;
  }
  return true;
}

double squared_m2(Point2 a, Point2 b) {
  const double dx = a.x_m - b.x_m;
  const double dy = a.y_m - b.y_m;
  return dx * dx + dy * dy;
}

double squared_to_segment_m2(Point2 p, Point2 from, Point2 to) {
  return squared_m2(p, nearest_on_segment(p, from, to));
}

double squared_between_m2(Point2 a, Point2 b, Point2 c, Point2 d) {
  if (segments_cross(a, b, c, d)) return 0.0;
  return std::min({squared_to_segment_m2(a, c, d), squared_to_segment_m2(b, c, d),
                   squared_to_segment_m2(c, a, b), squared_to_segment_m2(d, a, b)});
}

/// A rounded line has one side, a polygon as many as corners.
std::size_t sides_of(const std::vector<Point2>& corners) {
  return corners.size() == 2 ? 1 : corners.size();
}

/// From a point to the outline of a shape.
double squared_to_outline_m2(Point2 p, const std::vector<Point2>& corners) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < sides_of(corners); ++i) {
    nearest =
        std::min(nearest, squared_to_segment_m2(p, corners[i], corners[(i + 1) % corners.size()]));
  }
  return nearest;
}

double squared_between_outlines_m2(const std::vector<Point2>& a, const std::vector<Point2>& b) {
  if (a.size() == 1) return squared_to_outline_m2(a[0], b);
  if (b.size() == 1) return squared_to_outline_m2(b[0], a);
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < sides_of(a); ++i) {
    for (std::size_t j = 0; j < sides_of(b); ++j) {
      nearest = std::min(
          nearest, squared_between_m2(a[i], a[(i + 1) % a.size()], b[j], b[(j + 1) % b.size()]));
    }
  }
  return nearest;
}

}  // namespace

ConvexShape robot_footprint(const RobotDescription& robot) {
  const double cut = robot.corner_m / std::numbers::sqrt2;
  const double f = robot.front_m;
  const double r = -robot.rear_m;
  const double w = robot.half_width_m;
  return {{{f, -(w - cut)},
           {f, w - cut},
           {f - cut, w},
           {r + cut, w},
           {r, w - cut},
           {r, -(w - cut)},
           {r + cut, -w},
           {f - cut, -w}},
          0.0};
}

ConvexShape disc(Point2 middle, double radius_m) {
  return {{middle}, radius_m};
}

ConvexShape rectangle(const Pose2& middle, double size_x_m, double size_y_m) {
  const double x = size_x_m / 2;
  const double y = size_y_m / 2;
  return moved({{{x, -y}, {x, y}, {-x, y}, {-x, -y}}, 0.0}, middle);
}

ConvexShape moved(const ConvexShape& shape, const Pose2& pose) {
  ConvexShape result = shape;
  const double c = std::cos(pose.heading_rad);
  const double s = std::sin(pose.heading_rad);
  for (Point2& p : result.corners) {
    p = {pose.x_m + c * p.x_m - s * p.y_m, pose.y_m + s * p.x_m + c * p.y_m};
  }
  return result;
}

double distance_m(Point2 a, Point2 b) {
  return std::hypot(a.x_m - b.x_m, a.y_m - b.y_m);
}

Point2 nearest_on_segment(Point2 p, Point2 from, Point2 to) {
  const double dx = to.x_m - from.x_m;
  const double dy = to.y_m - from.y_m;
  const double squared = dx * dx + dy * dy;
  if (squared <= 0.0) return from;
  const double t =
      std::clamp(((p.x_m - from.x_m) * dx + (p.y_m - from.y_m) * dy) / squared, 0.0, 1.0);
  return {from.x_m + t * dx, from.y_m + t * dy};
}

double distance_to_segment_m(Point2 p, Point2 from, Point2 to) {
  return distance_m(p, nearest_on_segment(p, from, to));
}

bool segments_cross(Point2 a, Point2 b, Point2 c, Point2 d) {
  const double d1 = cross(c, d, a);
  const double d2 = cross(c, d, b);
  const double d3 = cross(a, b, c);
  const double d4 = cross(a, b, d);
  return ((d1 > 0.0) != (d2 > 0.0)) && ((d3 > 0.0) != (d4 > 0.0));
}

bool inside_polygon(Point2 p, const std::vector<Point2>& polygon) {
  bool inside = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Point2& a = polygon[i];
    const Point2& b = polygon[j];
    if ((a.y_m > p.y_m) != (b.y_m > p.y_m) &&
        p.x_m < (b.x_m - a.x_m) * (p.y_m - a.y_m) / (b.y_m - a.y_m) + a.x_m) {
      inside = !inside;
    }
  }
  return inside;
}

double bounding_radius_m(const ConvexShape& shape, Point2 middle) {
  double radius = 0.0;
  for (const Point2& p : shape.corners) radius = std::max(radius, distance_m(p, middle));
  return radius + shape.radius_m;
}

double distance_m(const ConvexShape& a, const ConvexShape& b) {
  if (inside_convex(b.corners.front(), a.corners) || inside_convex(a.corners.front(), b.corners)) {
    return 0.0;
  }
  const double apart = std::sqrt(squared_between_outlines_m2(a.corners, b.corners));
  return std::max(0.0, apart - a.radius_m - b.radius_m);
}

}  // namespace striate::simulator
