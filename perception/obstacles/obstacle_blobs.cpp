#include "striate/perception/obstacles/obstacle_blobs.hpp"

#include <algorithm>
#include <cmath>

namespace striate::perception {
namespace {

/// Columns without a hit inside one blob; the pool of find_standing() is as wide
constexpr int kWidestHole = 2;
/// Level disparity may change so much from column to column: kWindow of column_scan.cpp
constexpr double kBlobStep_px = 0.8;
/// Or by this share of itself, 6 cm at 1 m: a box's side seen at a slant (ours)
constexpr double kStepShare = 0.06;
/// And by this much over the whole blob: what is deeper is two things or a wall (ours)
constexpr double kDepthShare = 0.25;
constexpr int kFewestColumns = 2;  // columns; a single one has but the support of its neighbours

/// Depth over a blob, px of level disparity: two steps
constexpr double kDepth_px = 2.0 * kBlobStep_px;

double length(Point2 p) {
  return std::hypot(p.x_m, p.y_m);
}

Obstacle describe_blob(const std::vector<ColumnHit>& hits, int from, int to) {
  Obstacle o;
  o.from_u_px = from;
  o.to_u_px = to;
  o.distance_m = kNothing_m;
  int count = 0;
  double column_width_m = 0.0;
  for (int u = from; u <= to; ++u) {
    if (!hits[u].found) continue;
    ++count;
    o.distance_m = std::min(o.distance_m, length(hits[u].at));
    o.height_m = std::max(o.height_m, hits[u].height_m);
    o.confidence += hits[u].confidence;
  }
  o.confidence /= count;
  const Point2 a = hits[from].at;
  const Point2 b = hits[to].at;
  o.bearing_rad = std::atan2(0.5 * (a.y_m + b.y_m), 0.5 * (a.x_m + b.x_m));
  const double span_m = std::hypot(a.x_m - b.x_m, a.y_m - b.y_m);
  column_width_m = to > from ? span_m / (to - from) : 0.0;
  o.width_m = span_m + column_width_m;
  return o;
}

}  // namespace

std::vector<Obstacle> join_columns(const std::vector<ColumnHit>& hits) {
  std::vector<Obstacle> obstacles;
  const int width = static_cast<int>(hits.size());
  const auto near_enough = [&](const ColumnHit& a, const ColumnHit& b) {
    return std::abs(a.level_px - b.level_px) <= std::max(kBlobStep_px, kStepShare * a.level_px);
  };
  int first = -1;
  int last = -1;
  const auto close_blob = [&] {
    if (first >= 0 && last - first + 1 >= kFewestColumns) {
      obstacles.push_back(describe_blob(hits, first, last));
    }
    first = -1;
  };
  for (int u = 0; u < width; ++u) {
    if (!hits[u].found) continue;
    const bool joins = first >= 0 && u - last <= kWidestHole + 1 &&
                       near_enough(hits[last], hits[u]) &&
                       std::abs(hits[u].level_px - hits[first].level_px) <=
                           std::max(kDepth_px, kDepthShare * hits[first].level_px);
    if (!joins) {
      close_blob();
      first = u;
    }
    last = u;
  }
  close_blob();
  std::stable_sort(obstacles.begin(), obstacles.end(), [](const Obstacle& a, const Obstacle& b) {
    return a.distance_m < b.distance_m;
  });
  return obstacles;
}

}  // namespace striate::perception
