#include "striate/agent/pictures/plan_of_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "striate/agent/pictures/canvas.hpp"
#include "striate/base/geometry.hpp"

namespace striate::agent::pictures {
namespace {

constexpr int kFootRoom_px = 26;  // below the axle: the robot and its shadow (ours)
constexpr int kMostRings = 20;    // ring_for() makes six at most; more are no scale
constexpr int kFraction = 4;      // bits of sub-pixel that OpenCV draws with

class Plan {
 public:
  Plan(cv::Size size, const PlanScale& scale)
      : image(size, cv::Vec3b(38, 35, 33)),
        foot_(0.5 * size.width, size.height - kFootRoom_px),
        px_per_unit_((size.height - kFootRoom_px - 8) / scale.reach) {}

  /// Robot frame to fixed-point image coordinates.
  [[nodiscard]] cv::Point at(double x, double y) const {
    const double one = 1 << kFraction;
    return {drawn_px((foot_.x - y * px_per_unit_) * one),
            drawn_px((foot_.y - x * px_per_unit_) * one)};
  }
  [[nodiscard]] cv::Point polar(double bearing_rad, double distance) const {
    return at(distance * std::cos(bearing_rad), distance * std::sin(bearing_rad));
  }
  [[nodiscard]] cv::Point pixel(double x, double y) const {
    const cv::Point p = at(x, y);
    return {p.x >> kFraction, p.y >> kFraction};
  }
  [[nodiscard]] int pixels(double length) const { return drawn_px(length * px_per_unit_); }

  cv::Mat3b image;

 private:
  cv::Point2d foot_;
  double px_per_unit_;
};

void draw_rings(Plan& plan, const PlanScale& scale) {
  const int rings = cut_within((scale.reach + 1e-9) / scale.ring, 0, kMostRings);
  for (int k = 1; k <= rings; ++k) {
    const double r = k * scale.ring;
    cv::circle(plan.image, plan.pixel(0, 0), plan.pixels(r), {62, 58, 55}, 1, cv::LINE_AA);
    const cv::Point top = plan.pixel(r, 0);
    write(plan.image, fmt::format("{:g} {}", r, scale.unit), {top.x + 4, top.y + 13}, kQuietInk,
          0.75);
  }
}

/// The wedge that column `i` stands for, half way to its neighbours, between two distances.
void draw_wedge(Plan& plan, const std::vector<perception::Column>& columns, std::size_t i,
                cv::Vec2d from_to, const cv::Scalar& colour) {
  const perception::Column& c = columns[i];
  const double left = i > 0 ? 0.5 * (columns[i - 1].bearing_rad + c.bearing_rad) : c.bearing_rad;
  const double right =
      i + 1 < columns.size() ? 0.5 * (columns[i + 1].bearing_rad + c.bearing_rad) : c.bearing_rad;
  const std::vector<cv::Point> wedge{plan.polar(left, from_to[0]), plan.polar(left, from_to[1]),
                                     plan.polar(right, from_to[1]), plan.polar(right, from_to[0])};
  cv::fillConvexPoly(plan.image, wedge, colour, cv::LINE_8, kFraction);
}

/// Free floor, and floor that the obstacle hides.
void draw_floor(Plan& plan, const std::vector<perception::Column>& columns, std::size_t i,
                double reach) {
  const perception::Column& c = columns[i];
  if (c.free_to_m > c.free_from_m) {
    const double strength = 0.25 + 0.5 * c.free_confidence;
    draw_wedge(plan, columns, i, {c.free_from_m, c.free_to_m}, kFree * strength);
  }
  const double farthest = 2.0 * reach;
  if (c.hidden_from_m < farthest) {
    draw_wedge(plan, columns, i, {c.hidden_from_m, std::min(c.hidden_to_m, farthest)}, kHidden);
  }
}

void draw_obstacle(Plan& plan, const perception::Column& c) {
  if (!std::isfinite(c.obstacle_m)) return;
  const double strength = 0.35 + 0.65 * c.obstacle_confidence;
  cv::circle(plan.image, plan.polar(c.bearing_rad, c.obstacle_m), 2 << kFraction,
             kBlocked * strength, cv::FILLED, cv::LINE_AA, kFraction);
}

void draw_corridor(Plan& plan, const perception::CorridorView& corridor, double reach) {
  if (!corridor.valid) return;
  const double c = std::cos(corridor.heading_rad);
  const double s = std::sin(corridor.heading_rad);
  const auto wall = [&](double side_m, double from, int thickness) {
    cv::line(plan.image, plan.at(from * c - side_m * s, from * s + side_m * c),
             plan.at(2 * reach * c - side_m * s, 2 * reach * s + side_m * c), kCorridor, thickness,
             cv::LINE_AA, kFraction);
  };
  wall(0.0, 0.0, 1);
  if (std::isfinite(corridor.left_m)) wall(corridor.left_m, -reach, 2);
  if (std::isfinite(corridor.right_m)) wall(-corridor.right_m, -reach, 2);
}

}  // namespace

cv::Mat3b draw_plan_of_columns(const perception::Percept& percept, cv::Size size,
                               const PlanScale& scale) {
  Plan plan(size, scale);
  for (std::size_t i = 0; i < percept.columns.size(); ++i) {
    draw_floor(plan, percept.columns, i, scale.reach);
  }
  draw_rings(plan, scale);
  draw_corridor(plan, percept.corridor, scale.reach);
  for (const perception::Column& column : percept.columns) draw_obstacle(plan, column);
  const int half = std::clamp(plan.pixels(scale.robot), 4, 14);
  const cv::Point foot = plan.pixel(0, 0);
  cv::circle(plan.image, foot, half, kInk, cv::FILLED, cv::LINE_AA);
  cv::line(plan.image, foot, {foot.x, foot.y - half - 6}, kInk, 2, cv::LINE_AA);
  return plan.image;
}

}  // namespace striate::agent::pictures
