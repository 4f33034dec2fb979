#include "striate/perception/obstacles/free_floor.hpp"

#include <algorithm>
#include <cmath>

namespace striate::perception {
namespace {

/// Columns to either side that are looked at together, as in column_scan.cpp
constexpr int kPoolOfFloor = 2;
/// Least mean weight of a row: a quarter of it surely floor, or half with a promise of 0.5
constexpr double kFloorSeen = 0.25;
/// Rows of something standing that end the floor: a single one may be a wrong match
constexpr int kBlockedRows = 2;

struct RowEvidence {
  double floor = 0.0;
  double beneath = 0.0;
  double standing = 0.0;
};

/// Mean evidence of a row over a column and its neighbours.
RowEvidence row_evidence(const JudgedMap& judged, int v, int u) {
  RowEvidence sum;
  const int from = std::max(0, u - kPoolOfFloor);
  const int to = std::min(judged.kind.cols - 1, u + kPoolOfFloor);
  for (int c = from; c <= to; ++c) {
    const double weight = judged.weight(v, c);
    switch (static_cast<PixelKind>(judged.kind(v, c))) {
      case PixelKind::floor:
        sum.floor += weight;
        break;
      case PixelKind::beneath:
        sum.beneath += weight;
        break;
      case PixelKind::standing:
        sum.standing += weight;
        break;
      default:
        break;
    }
  }
  const double n = to - from + 1;
  return {sum.floor / n, sum.beneath / n, sum.standing / n};
}

/// Distance along the floor of every row, from the camera's foot; empty above `farthest_floor_m`.
std::vector<double> floor_rows(const ViewGeometry& geometry, int rows, double farthest_m) {
  std::vector<double> distance(rows, -1.0);
  for (int v = 0; v < rows; ++v) {
    const double d = geometry.floor_disparity_px(v);
    if (d <= 0.0) continue;
    const double level = d * geometry.level_factor(v);
    const double forward_m = geometry.focal_baseline() / level;
    if (forward_m <= farthest_m) distance[v] = forward_m;
  }
  return distance;
}

FreeFloor follow_floor(const JudgedMap& judged, const std::vector<double>& distance, int u,
                       double gap_m) {
  FreeFloor free;
  double sum = 0.0;
  int rows = 0;
  int rows_at_end = 0;
  double sum_at_end = 0.0;
  int blocked = 0;
  double known_to_m = distance.back();
  for (int v = judged.kind.rows - 1; v >= 0 && distance[v] > 0.0; --v) {
    const RowEvidence row = row_evidence(judged, v, u);
    blocked = row.standing > row.floor ? blocked + 1 : 0;
    if (blocked >= kBlockedRows) break;
    const bool seen = row.floor >= kFloorSeen && row.floor > row.standing;
    if (distance[v] - known_to_m > gap_m) break;
    // A mirror image bridges the floor around it; alone it may as well lie in a table top.
    if (seen || (free.from_row >= 0 && row.beneath > row.standing && row.beneath >= kFloorSeen)) {
      known_to_m = distance[v];
    }
    if (free.from_row < 0 && !seen) continue;
    if (free.from_row < 0) free.from_row = free.to_row = v;
    ++rows;
    if (seen) {
      sum += row.floor;
      free.to_row = v;
      sum_at_end = sum;
      rows_at_end = rows;
    }
  }
  if (rows_at_end > 0) free.confidence = sum_at_end / rows_at_end;
  return free;
}

}  // namespace

std::vector<FreeFloor> find_free_floor(const JudgedMap& judged, const ViewGeometry& geometry,
                                       const ObstacleSettings& settings) {
  const std::vector<double> distance =
      floor_rows(geometry, judged.kind.rows, settings.farthest_floor_m);
  std::vector<FreeFloor> free(judged.kind.cols);
  for (int u = 0; u < judged.kind.cols; ++u) {
    free[u] = follow_floor(judged, distance, u, settings.floor_gap_m);
  }
  return free;
}

double calibrate_floor(const DisparityMap& map, const ViewGeometry& geometry,
                       const ObstacleSettings& settings) {
  if (settings.floor_offset_px <= 0.0) return 0.0;
  // px: pixels within this of the line are taken for floor; above floor_offset_px and noise
  constexpr double kNear_px = 0.75;
  // Pixels; the median of 300 that err by 1 px is known to 1.25 / sqrt(300) = 0.07 px
  constexpr std::size_t kFewest = 300;
  // px of disparity: nearer to the horizon (12 m) walls touch the line
  constexpr double kLeastFloor_px = 2.0;
  std::vector<float> residuals;
  for (int v = 0; v < map.disparity_px.rows; ++v) {
    const double floor_px = geometry.floor_disparity_px(v);
    if (floor_px < kLeastFloor_px) continue;
    for (int u = 0; u < map.disparity_px.cols; ++u) {
      const double residual = map.disparity_px(v, u) - floor_px;
      if (map.confidence(v, u) < settings.trusted || !(std::abs(residual) <= kNear_px)) continue;
      residuals.push_back(static_cast<float>(residual));
    }
  }
  if (residuals.size() < kFewest) return 0.0;
  const auto middle = residuals.begin() + static_cast<std::ptrdiff_t>(residuals.size() / 2);
  std::nth_element(residuals.begin(), middle, residuals.end());
  return std::clamp<double>(*middle, -settings.floor_offset_px, settings.floor_offset_px);
}

}  // namespace striate::perception
