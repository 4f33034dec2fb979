#include "striate/perception/obstacles/column_scan.hpp"

#include <algorithm>
#include <cmath>

#include "striate/base/index_within.hpp"

namespace striate::perception {
namespace {

/// Level disparity; about the error of a trusted one, which kScanWindow bins take up
constexpr double kBin_px = 0.25;
/// Level disparities up to 96 px: 0.25 m with the shipped camera at width 160
constexpr int kRowBins = 384;
/// Columns to either side that lend support: 5 are 2.5 cm wide at 1 m (Z / f each), 0.1 m at 4 m
constexpr int kPooledColumns = 2;
constexpr double kPoolFilled = 0.6;  // share of the pooled columns that must show it: three of five
/// Bins to either side that count as the same distance: 0.75 px, a disparity right within 1 px
constexpr int kScanWindow = 3;
// Level disparity of a plane changes by baseline / lateral distance per column: 0.25 px is a wall
// half a metre beside the camera.
/// px a column, baseline / lateral distance: a wall half a metre beside the camera (0.12 / 0.5)
constexpr double kSteepestPlane = 0.25;
constexpr double kPlaneSlack_px = 0.5;  // two ends that each err by a bin of 0.25 px

/// Level disparity, px: what is farther than a plane by more is seen through it
constexpr double kBehind_px = 1.0;
/// Support of a bridge, of the weaker of its ends (ours)
constexpr double kBridgeSupport = 0.5;

float ramp(double value, double from, double to) {
  return static_cast<float>(std::clamp((value - from) / (to - from), 0.0, 1.0));
}

/// Support needed at level disparity e: a height in the world over most of the columns that are
/// pooled, but never less than a few pixels.
double needed_support(double level_px, const ViewGeometry& geometry,
                      const ObstacleSettings& settings) {
  const double px_per_m = geometry.focal_px() * level_px / geometry.focal_baseline();
  return std::max(settings.smallest_px,
                  kPoolFilled * (2 * kPooledColumns + 1) * settings.smallest_m * px_per_m);
}

using RowHistogram = std::vector<float>;  // one column's weight per bin

void add_column(const JudgedMap& judged, int u, RowHistogram& sum, float sign) {
  for (int v = 0; v < judged.kind.rows; ++v) {
    if (static_cast<PixelKind>(judged.kind(v, u)) != PixelKind::standing) continue;
    const int bin = cut_within(judged.level(v, u) / kBin_px, 0, kRowBins);
    if (bin < kRowBins) sum[bin] += sign * judged.weight(v, u);
  }
}

/// Sum of the bins within kScanWindow of `bin`.
double window_sum(const RowHistogram& histogram, int bin) {
  double sum = 0.0;
  const int last = std::min(kRowBins - 1, bin + kScanWindow);
  for (int b = std::max(0, bin - kScanWindow); b <= last; ++b) sum += histogram[b];
  return sum;
}

/// The nearest bin with enough support, then uphill to the middle of that support; -1: none.
int nearest_peak(const RowHistogram& histogram, const std::vector<double>& needed, int first_bin) {
  for (int bin = kRowBins - 1; bin >= first_bin; --bin) {
    double best = window_sum(histogram, bin);
    if (best < needed[bin]) continue;
    int peak = bin;
    for (int b = bin - 1; b >= std::max(first_bin, bin - 2 * kScanWindow); --b) {
      const double sum = window_sum(histogram, b);
      if (sum > best) {
        best = sum;
        peak = b;
      }
    }
    return peak;
  }
  return -1;
}

/// Where the pixels of columns `from` to `to` lie whose level disparity is near that of `peak`.
Standing measure(const JudgedMap& judged, int from, int to, int peak) {
  Standing found;
  const double middle = (peak + 0.5) * kBin_px;
  double weight = 0.0;
  found.top_row = judged.kind.rows;
  found.bottom_row = -1;
  for (int u = from; u <= to; ++u) {
    for (int v = 0; v < judged.kind.rows; ++v) {
      if (static_cast<PixelKind>(judged.kind(v, u)) != PixelKind::standing) continue;
      const double level = judged.level(v, u);
      if (std::abs(level - middle) > (kScanWindow + 1) * kBin_px) continue;
      const double w = judged.weight(v, u);
      weight += w;
      found.level_px += w * level;
      found.row_px += w * v;
      found.top_row = std::min(found.top_row, v);
      found.bottom_row = std::max(found.bottom_row, v);
    }
  }
  if (weight > 0.0) {
    found.level_px /= weight;
    found.row_px /= weight;
  }
  return found;
}

}  // namespace

JudgedMap judge_pixels(const DisparityMap& map, const ViewGeometry& geometry,
                       const ObstacleSettings& settings, double floor_offset_px) {
  const cv::Size size = map.disparity_px.size();
  JudgedMap judged{cv::Mat1b(size, static_cast<uchar>(PixelKind::unknown)), cv::Mat1f(size, 0.0F),
                   cv::Mat1f(size, 0.0F)};
  const double h = geometry.camera_height_m();
  for (int v = 0; v < size.height; ++v) {
    const double floor_px = geometry.floor_disparity_px(v) + floor_offset_px;
    const double level_factor = geometry.level_factor(v);
    if (!(level_factor > 0.0)) continue;  // such a row looks straight down or behind
    for (int u = 0; u < size.width; ++u) {
      const double d = map.disparity_px(v, u);
      const float trust = map.confidence(v, u);
      if (!std::isfinite(d) || trust < settings.trusted || d <= 0.0) continue;
      const double above_px = d - floor_px;
      const double height = h * above_px / d;
      PixelKind kind = PixelKind::standing;
      float weight = trust;
      if (height > settings.highest_m) {
        kind = PixelKind::overhead;
      } else if (above_px < -settings.standing_px) {
        kind = PixelKind::beneath;
      } else if (above_px <= settings.floor_margin_px || height < settings.lowest_m) {
        kind = PixelKind::floor;
      } else {
        weight *= ramp(above_px, settings.floor_margin_px, settings.standing_px);
        judged.level(v, u) = static_cast<float>(d * level_factor);
      }
      judged.kind(v, u) = static_cast<uchar>(kind);
      judged.weight(v, u) = weight;
    }
  }
  return judged;
}

std::vector<Standing> find_standing(const JudgedMap& judged, const ViewGeometry& geometry,
                                    const ObstacleSettings& settings) {
  const int width = judged.kind.cols;
  std::vector<Standing> found(width);
  std::vector<double> needed(kRowBins);
  for (int b = 0; b < kRowBins; ++b) {
    needed[b] = needed_support((b + 0.5) * kBin_px, geometry, settings);
  }
  const int first_bin =
      cut_within(geometry.focal_baseline() / settings.farthest_m / kBin_px, 1, kRowBins);
  RowHistogram pooled(kRowBins, 0.0F);
  for (int u = 0; u < std::min(kPooledColumns, width); ++u) add_column(judged, u, pooled, 1.0F);
  for (int u = 0; u < width; ++u) {
    if (u + kPooledColumns < width) add_column(judged, u + kPooledColumns, pooled, 1.0F);
    if (u - kPooledColumns - 1 >= 0) add_column(judged, u - kPooledColumns - 1, pooled, -1.0F);
    const int peak = nearest_peak(pooled, needed, first_bin);
    if (peak < 0) continue;
    found[u] = measure(judged, u, u, peak);
    if (found[u].level_px <= 0.0) {
      found[u] = measure(judged, std::max(0, u - 1), std::min(width - 1, u + 1), peak);
    }
    if (found[u].level_px > 0.0) found[u].support = window_sum(pooled, peak) / needed[peak];
  }
  return found;
}

void bridge_unknown_columns(std::vector<Standing>& standing, const JudgedMap& judged,
                            const ObstacleSettings& settings) {
  const int width = static_cast<int>(standing.size());
  int left = -1;
  for (int right = 0; right < width; ++right) {
    if (standing[right].level_px <= 0.0) continue;
    const int gap = right - left - 1;
    if (left >= 0 && gap > 0 && gap <= settings.bridged_columns) {
      const Standing a = standing[left];
      const Standing b = standing[right];
      const double step = std::abs(b.level_px - a.level_px);
      if (step > kPlaneSlack_px + kSteepestPlane * (gap + 1)) {
        left = right;
        continue;
      }
      for (int u = left + 1; u < right; ++u) {
        const double t = static_cast<double>(u - left) / (right - left);
        const double level = a.level_px + t * (b.level_px - a.level_px);
        int farther = 0;
        for (int v = 0; v < judged.kind.rows; ++v) {
          farther += static_cast<PixelKind>(judged.kind(v, u)) == PixelKind::standing &&
                     judged.level(v, u) < level - kBehind_px;
        }
        if (farther > settings.smallest_px) continue;
        standing[u] = {level,
                       a.row_px + t * (b.row_px - a.row_px),
                       kBridgeSupport * std::min(a.support, b.support),
                       std::min(a.top_row, b.top_row),
                       std::max(a.bottom_row, b.bottom_row),
                       true};
      }
    }
    left = right;
  }
}

}  // namespace striate::perception
