#include "striate/memory/long_term/map_alignment.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace striate::memory {
namespace {

constexpr double kApartOnMaps_m = 1.0;  // by hand: nearer, two say little about the heading
constexpr double kGate = 13.8;          ///< chi squared of 99.9 %, two degrees of freedom
constexpr double kLeastError_m = 0.1;   ///< by hand: twice the error of a landmark's middle

bool agrees(const Pose2& origin, const OnBothMaps& one) {
  const Point2 at = transform(origin, Point2{one.theirs.x_m, one.theirs.y_m});
  const double variance_m2 = std::max(one.theirs.var_x_m2, one.theirs.var_y_m2) +
                             std::max(one.ours.var_x_m2, one.ours.var_y_m2) +
                             kLeastError_m * kLeastError_m;
  const double dx = at.x_m - one.ours.x_m;
  const double dy = at.y_m - one.ours.y_m;
  return dx * dx + dy * dy <= kGate * variance_m2;
}

/// The rigid motion of least squares (Horn 1987, in two dimensions).
Pose2 best_motion(const std::vector<OnBothMaps>& pairs) {
  const auto count = static_cast<double>(pairs.size());
  Point2 theirs, ours;
  for (const OnBothMaps& one : pairs) {
    theirs.x_m += one.theirs.x_m / count;
    theirs.y_m += one.theirs.y_m / count;
    ours.x_m += one.ours.x_m / count;
    ours.y_m += one.ours.y_m / count;
  }
  double along = 0.0, across = 0.0;
  for (const OnBothMaps& one : pairs) {
    const double ax = one.theirs.x_m - theirs.x_m, ay = one.theirs.y_m - theirs.y_m;
    const double bx = one.ours.x_m - ours.x_m, by = one.ours.y_m - ours.y_m;
    along += ax * bx + ay * by;
    across += ax * by - ay * bx;
  }
  const Pose2 turn{0.0, 0.0, std::atan2(across, along)};
  const Point2 turned = transform(turn, theirs);
  return {ours.x_m - turned.x_m, ours.y_m - turned.y_m, turn.heading_rad};
}

}  // namespace

std::optional<Pose2> align_maps(const std::vector<OnBothMaps>& common) {
  std::vector<OnBothMaps> best;
  for (std::size_t a = 0; a < common.size(); ++a) {
    for (std::size_t b = a + 1; b < common.size(); ++b) {
      if (std::hypot(common[a].ours.x_m - common[b].ours.x_m,
                     common[a].ours.y_m - common[b].ours.y_m) < kApartOnMaps_m) {
        continue;
      }
      const Pose2 origin = best_motion({common[a], common[b]});
      std::vector<OnBothMaps> agreeing;
      std::copy_if(common.begin(), common.end(), std::back_inserter(agreeing),
                   [&](const OnBothMaps& one) { return agrees(origin, one); });
      if (agreeing.size() > best.size()) best = agreeing;
    }
  }
  if (best.size() < 2 || 2 * best.size() <= common.size()) return std::nullopt;
  return best_motion(best);
}

MapPosition on_our_map(const Pose2& their_origin, const MapPosition& theirs) {
  const Point2 at = transform(their_origin, Point2{theirs.x_m, theirs.y_m});
  const double c = std::cos(their_origin.heading_rad);
  const double s = std::sin(their_origin.heading_rad);
  const double xx = theirs.var_x_m2, xy = theirs.cov_xy_m2, yy = theirs.var_y_m2;
  const double error_m2 = kLeastError_m * kLeastError_m;  // of the alignment itself
  return {at.x_m, at.y_m, c * c * xx - 2.0 * c * s * xy + s * s * yy + error_m2,
          c * s * (xx - yy) + (c * c - s * s) * xy,
          s * s * xx + 2.0 * c * s * xy + c * c * yy + error_m2};
}

}  // namespace striate::memory
