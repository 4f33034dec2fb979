#include "striate/memory/short_term/corridor_memory.hpp"

#include <algorithm>
#include <cmath>

namespace striate::memory {
namespace {

// Ours, from the published drift of the base: 0.75 % of the way and of the turning.
// "By hand": README.md, "Where the numbers come from"; the tests are CorridorMemory.*.
constexpr double kStartHeadingStd_rad = 0.10;  // by hand: a robot is put down along the corridor
constexpr double kStartOffsetStd_m = 0.30;     // by hand: and about in its middle
constexpr double kTurnDrift = 0.015;           // of the turning, twice what is published
constexpr double kHeadingWalk_rad = 0.008;     // by hand, per square root of a metre
constexpr double kOffsetWalk_m = 0.05;         // by hand, per square root of a metre
// Gates: by hand at least so wide, else 2.5 sigma (98.8 % of a Gaussian); dissent for so many looks
// in a row opens the filter until the look lies within three sigma.
constexpr double kHeadingGate_rad = 0.12;
constexpr double kOffsetGate_m = 0.35;
constexpr double kGateSigmas = 2.5;
constexpr double kOpenedVariance = 9.0;  // three sigma, squared
// By hand, looks: the walls of images (0.1 s each), the heading, and the edges of seen floor.
constexpr int kWallPatience = 30;
constexpr int kHeadingPatience = 40;
constexpr int kEdgePatience = 60;
// By hand, sigma of one look at full confidence: images and both walls in the map are as good,
// one wall and the edges of seen floor worse. Less confidence than the last is no look.
constexpr double kHeadingSigma_rad = 0.05;
constexpr double kOneWallSigma_rad = 0.08;
constexpr double kEdgesSigma_rad = 0.10;
constexpr double kWallSigma_m = 0.15;
constexpr double kEdgesVariance_m2 = 0.16;  // by hand: sigma 0.40 m
constexpr double kLeastConfidence = 0.05;   // by hand: share; below it a look is no look
// Looks in a row share their errors, by hand four of them: each counts for less than its own
// variance says.
constexpr double kCorrelation = 4.0;
constexpr double kOneWallDoubt = 2.0;  // by hand, times the variance: the width may have changed
// By hand: the width is averaged over 17 looks once the first ones have put it about right.
constexpr double kWidthGain = 0.06;
constexpr double kFirstWidthGain = 0.5;
// By hand: narrower is a gap between things, wider a hall.
constexpr double kLeastWidth_m = 1.0;
constexpr double kMostWidth_m = 6.5;
// By hand: a wall that leaps so far is another one; else a third of the difference is believed.
constexpr double kAnotherWall_m = 0.5;
constexpr double kWallGain = 0.3;

double square(double x) {
  return x * x;
}

}  // namespace

bool CorridorMemory::Estimate::take(double innovation, double variance_seen, double least_gate,
                                    int patience) {
  const double gate = std::max(least_gate, kGateSigmas * std::sqrt(variance + variance_seen));
  if (std::abs(innovation) > gate) {
    // Long, unanimous dissent opens the filter instead of jumping.
    if (++rejected > patience) variance = std::max(variance, square(innovation) / kOpenedVariance);
    return false;
  }
  rejected = 0;
  const double gain = variance / (variance + variance_seen);
  value += gain * innovation;
  variance *= 1.0 - gain;
  return true;
}

void CorridorMemory::Wall::see(double seen_m) {
  const bool fresh = !known() || std::abs(seen_m - distance_m) > kAnotherWall_m;
  distance_m += (fresh ? 1.0 : kWallGain) * (seen_m - distance_m);
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
      inverse_transform(Pose2{before.x_m, before.y_m, axis_.value}, Point2{after.x_m, after.y_m});
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

void CorridorMemory::see(const perception::CorridorView& view, const Pose2& at, const Pose2& now) {
  if (!started_ || !view.valid || view.confidence <= kLeastConfidence) return;
  const double confidence = std::clamp(view.confidence, kLeastConfidence, 1.0);
  see_heading(wrap_angle(at.heading_rad + view.heading_rad), kHeadingSigma_rad / confidence);
  // Since the image the robot has moved across by this much.
  const double moved_m =
      inverse_transform(Pose2{at.x_m, at.y_m, axis_.value}, Point2{now.x_m, now.y_m}).y_m;
  see_walls(view.left_m - moved_m, view.right_m + moved_m, kWallSigma_m / confidence);
}

void CorridorMemory::see(const WallFit& fit, Source source) {
  if (!started_ || !fit.valid) return;
  if (source == Source::edges) {  // the width was assumed, so the walls say nothing new about it
    see_heading(fit.heading_rad, kEdgesSigma_rad);
    offset_.take(0.5 * (fit.right_m - fit.left_m) - offset_.value, kEdgesVariance_m2, kOffsetGate_m,
                 kEdgePatience);
    return;
  }
  see_heading(fit.heading_rad, fit.left && fit.right ? kHeadingSigma_rad : kOneWallSigma_rad);
  see_walls(fit.left ? fit.left_m : perception::kNothing_m,
            fit.right ? fit.right_m : perception::kNothing_m, kWallSigma_m);
}

void CorridorMemory::see_heading(double heading_rad, double std_rad) {
  axis_.take(wrap_angle(heading_rad - axis_.value), kCorrelation * square(std_rad),
             kHeadingGate_rad, kHeadingPatience);
  axis_.value = wrap_angle(axis_.value);
}

void CorridorMemory::see_walls(double left_m, double right_m, double std_m) {
  if (std::isfinite(left_m)) left_.see(left_m);
  if (std::isfinite(right_m)) right_.see(right_m);
  const double variance = kCorrelation * square(std_m);
  if (std::isfinite(left_m) && std::isfinite(right_m)) {
    const double width_m = left_m + right_m;
    if (width_m < kLeastWidth_m || width_m > kMostWidth_m) return;
    offset_.take(0.5 * (right_m - left_m) - offset_.value, variance, kOffsetGate_m, kWallPatience);
    width_m_ += (width_looks_ < kWidthLooks ? kFirstWidthGain : kWidthGain) * (width_m - width_m_);
    ++width_looks_;
  } else if (width_known() && (std::isfinite(left_m) || std::isfinite(right_m))) {
    const double seen_m =
        std::isfinite(left_m) ? 0.5 * width_m_ - left_m : right_m - 0.5 * width_m_;
    // One wall tells the middle only as far as the width is still what it was.
    if (std::abs(seen_m - offset_.value) < kOffsetGate_m) {
      offset_.take(seen_m - offset_.value, kOneWallDoubt * variance, kOffsetGate_m, kWallPatience);
    }
  }
}

}  // namespace striate::memory
