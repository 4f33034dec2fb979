#include "striate/behaviours/control/footprint.hpp"

#include <algorithm>
#include <cmath>

namespace striate::behaviours {

Footprint::Footprint(const RobotDescription& robot)
    : front_m_(robot.front_m), rear_m_(robot.rear_m), half_width_m_(robot.half_width_m) {
  const double f = front_m_;
  const double r = -rear_m_;
  const double h = half_width_m_;
  const double third = (f - r) / 3.0;
  outline_ = {Point2{f, h},         Point2{f, h / 3},      Point2{f, -h / 3},
              Point2{f, -h},        Point2{f - third, h},  Point2{f - third, -h},
              Point2{r + third, h}, Point2{r + third, -h}, Point2{r, h},
              Point2{r, h / 3},     Point2{r, -h / 3},     Point2{r, -h}};
}

double Footprint::clearance_m(const FloorField& field, const Pose2& pose) const {
  double least = FloorField::kFar_m;
  for (const Point2& corner : outline_) {
    least = std::min(least, field.clearance_m(transform(pose, corner)));
  }
  return least;
}

double Footprint::seen_clearance_m(const FloorField& field, const Pose2& pose) const {
  double least = FloorField::kFar_m;
  for (const Point2& corner : outline_) {
    least = std::min(least, field.seen_clearance_m(transform(pose, corner)));
  }
  return least;
}

double Footprint::distance_m(Point2 p) const {
  const double dx = std::max(p.x_m - front_m_, -rear_m_ - p.x_m);
  const double dy = std::abs(p.y_m) - half_width_m_;
  if (dx > 0.0 && dy > 0.0) return std::hypot(dx, dy);
  return std::max(dx, dy);
}

double Footprint::farthest_left_m(const Pose2& pose) const {
  double most_m = -FloorField::kFar_m;
  for (const Point2& corner : outline_) most_m = std::max(most_m, transform(pose, corner).y_m);
  return most_m;
}

double Footprint::farthest_right_m(const Pose2& pose) const {
  return farthest_left_m({pose.x_m, -pose.y_m, -pose.heading_rad});
}

Pose2 along_arc(const Pose2& from, double forward_m_s, double turn_rad_s, double time_s) {
  const double turned = turn_rad_s * time_s;
  const double way_m = forward_m_s * time_s;
  // sin(x)/x and (1-cos(x))/x without the division by zero
  const double s = std::abs(turned) < 1e-6 ? 1.0 : std::sin(turned) / turned;
  const double c = std::abs(turned) < 1e-6 ? 0.5 * turned : (1.0 - std::cos(turned)) / turned;
  return transform(from, Pose2{way_m * s, way_m * c, turned});
}

}  // namespace striate::behaviours
