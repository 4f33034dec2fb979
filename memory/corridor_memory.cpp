#include "memory/corridor_memory.hpp"

#include <algorithm>
#include <cmath>

namespace striate {
namespace {

// Ours, from the published drift of the base: 0.75 % of the way and of the turning.
constexpr double kStartHeadingStd_rad = 0.10;
constexpr double kStartOffsetStd_m = 0.30;
constexpr double kTurnDrift = 0.015;        // of the turning, twice what is published
constexpr double kHeadingWalk_rad = 0.008;  // per square root of a metre
constexpr double kOffsetWalk_m = 0.05;      // per square root of a metre
constexpr double kHeadingGate_rad = 0.12;
constexpr double kOffsetGate_m = 0.35;
constexpr double kWidthGain = 0.06;
constexpr double kLeastWidth_m = 1.0;
constexpr double kMostWidth_m = 6.5;

double square(double x) {
  return x * x;
}

}  // namespace

bool CorridorMemory::Estimate::take(double innovation, double variance_seen, double least_gate,
                                    int patience) {
  const double gate = std::max(least_gate, 2.5 * std::sqrt(variance + variance_seen));
  if (std::abs(innovation) > gate) {
    // Long, unanimous dissent opens the filter instead of jumping.
    if (++rejected > patience) variance = std::max(variance, square(innovation) / 9.0);
    return false;
  }
  rejected = 0;
  const double gain = variance / (variance + variance_seen);
  value += gain * innovation;
  variance *= 1.0 - gain;
  return true;
}

void CorridorMemory::Wall::see(double seen_m) {
  const bool fresh = !known() || std::abs(seen_m - distance_m) > 0.5;
  distance_m += (fresh ? 1.0 : 0.3) * (seen_m - distance_m);
  unseen_m = 0.0;
}

void CorridorMemory::start(const Pose2& robot) {
  *this = {};
  started_ = true;
  axis_ = {robot.heading_rad, square(kStartHeadingStd_rad), 0};
  offset_ = {0.0, square(kStartOffsetStd_m), 0};
}

double CorridorMemory::axis_std_rad() const {
  return std::sqrt(axis_.variance);
}
double CorridorMemory::offset_std_m() const {
  return std::sqrt(offset_.variance);
}

void CorridorMemory::move(const Pose2& before, const Pose2& after) {
  const Point2 way =
      to_inner(Pose2{before.x_m, before.y_m, axis_.value}, Point2{after.x_m, after.y_m});
  const double way_m = std::hypot(way.x_m, way.y_m);
  const double turned_rad = std::abs(wrap_angle(after.heading_rad - before.heading_rad));
  progress_m_ += way.x_m;
  offset_.value += way.y_m;
  left_.distance_m -= way.y_m;
  right_.distance_m += way.y_m;
  left_.unseen_m += way_m;
  right_.unseen_m += way_m;
  axis_.variance += square(kHeadingWalk_rad) * way_m + square(kTurnDrift * turned_rad);
  offset_.variance += square(kOffsetWalk_m) * way_m + axis_.variance * square(way_m);
}

void CorridorMemory::see(const CorridorView& view, const Pose2& at, const Pose2& now) {
  if (!started_ || !view.valid || view.confidence <= 0.05) return;
  const double confidence = std::clamp(view.confidence, 0.05, 1.0);
  see_heading(wrap_angle(at.heading_rad + view.heading_rad), 0.05 / confidence);
  // Since the picture the robot has moved across by this much.
  const double moved_m = to_inner(Pose2{at.x_m, at.y_m, axis_.value}, Point2{now.x_m, now.y_m}).y_m;
  see_walls(view.left_m - moved_m, view.right_m + moved_m, 0.15 / confidence);
}

void CorridorMemory::see(const WallFit& fit, Source source) {
  if (!started_ || !fit.valid) return;
  if (source == Source::edges) {  // the width was assumed, so the walls say nothing new about it
    see_heading(fit.heading_rad, 0.10);
    offset_.take(0.5 * (fit.right_m - fit.left_m) - offset_.value, 0.16, kOffsetGate_m, 60);
    return;
  }
  see_heading(fit.heading_rad, fit.left && fit.right ? 0.05 : 0.08);
  see_walls(fit.left ? fit.left_m : kNothing_m, fit.right ? fit.right_m : kNothing_m, 0.15);
}

void CorridorMemory::see_heading(double heading_rad, double std_rad) {
  // Looks in a row share their errors: each counts for less than its own variance says.
  constexpr double kCorrelation = 4.0;
  axis_.take(wrap_angle(heading_rad - axis_.value), kCorrelation * square(std_rad),
             kHeadingGate_rad, 40);
  axis_.value = wrap_angle(axis_.value);
}

void CorridorMemory::see_walls(double left_m, double right_m, double std_m) {
  if (std::isfinite(left_m)) left_.see(left_m);
  if (std::isfinite(right_m)) right_.see(right_m);
  constexpr double kCorrelation = 4.0;
  const double variance = kCorrelation * square(std_m);
  if (std::isfinite(left_m) && std::isfinite(right_m)) {
    const double width_m = left_m + right_m;
    if (width_m < kLeastWidth_m || width_m > kMostWidth_m) return;
    offset_.take(0.5 * (right_m - left_m) - offset_.value, variance, kOffsetGate_m, 30);
    width_m_ += (width_looks_ < 3 ? 0.5 : kWidthGain) * (width_m - width_m_);
    ++width_looks_;
  } else if (width_known() && (std::isfinite(left_m) || std::isfinite(right_m))) {
    const double seen_m =
        std::isfinite(left_m) ? 0.5 * width_m_ - left_m : right_m - 0.5 * width_m_;
    // One wall tells the middle only as far as the width is still what it was.
    if (std::abs(seen_m - offset_.value) < kOffsetGate_m) {
      offset_.take(seen_m - offset_.value, 2.0 * variance, kOffsetGate_m, 30);
    }
  }
}

}  // namespace striate
