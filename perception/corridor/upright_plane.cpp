#include "striate/perception/corridor/upright_plane.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace striate::perception {
namespace {

/// Confidence: all promises (0.5 and more) pass; of scores of 0.4 73 % are right (confidence_fit)
constexpr double kTrusted = 0.4;
/// Above the floor: what one px of disparity is worth in height 4 m away (1.2 m / 6.1 px)
constexpr double kLowest_m = 0.2;
constexpr double kHighest_m = 2.6;  ///< just below the ceiling of the shipped corridors (2.7 m)
/// One px of disparity is 2 m there, at width 160: beyond, all is one plane
constexpr double kFarthest_m = 7.0;
/// px between samples, in u and v: some 770 of 160 x 120, enough for shares of 0.12
constexpr int kEvery = 5;
/// Pairs: find a plane of a fifth of the samples in 1 - (1 - 0.2^2)^80 = 96 %
constexpr int kTries = 80;
/// Level disparity: about the error of a sub-pixel match (ours)
constexpr double kTolerance_px = 0.3;
/// Of the samples: just above what lies on a plane by chance (0.1, corridor_view.cpp)
constexpr double kLeastShare = 0.12;
/// Errors of 0.3 px at both ends turn the slope by no more than 0.03 px a column
constexpr double kLeastWidth_px = 20.0;
constexpr double kLeastAlong_m = 0.8;  ///< about a door leaf: what is shorter is furniture (ours)
constexpr int kMostPlanes = 2;         ///< a corridor has two walls

/// Samples; what is fewer than a twelfth of a full image's is no plane but clutter (ours)
constexpr std::size_t kFewestSamples = 60;
/// Level disparity, px, 49 m away: keeps the ends of a plane on this side of its vanishing point
constexpr double kFarthestLevel_px = 0.5;
/// A twentieth of the inliers at either end is not counted in its width: chance hits (ours)
constexpr std::size_t kTrimmedPart = 20;

struct LevelSample {
  double u = 0.0;
  double level = 0.0;
};

struct Fit {
  double at_zero = 0.0;  ///< level disparity at u = 0
  double slope = 0.0;    ///< per column
  int inliers = 0;
};

std::vector<LevelSample> take_samples(const DisparityMap& map, const ViewGeometry& geometry) {
  std::vector<LevelSample> samples;
  const double least = geometry.focal_baseline() / kFarthest_m;
  for (int v = 2; v < map.disparity_px.rows; v += kEvery) {
    const double factor = geometry.level_factor(v);
    for (int u = 2 + (v / kEvery) % 2 * (kEvery / 2); u < map.disparity_px.cols; u += kEvery) {
      const float d = map.disparity_px(v, u);
      if (!std::isfinite(d) || d <= 0.0F || map.confidence(v, u) < kTrusted) continue;
      const double height_m = geometry.height_m(v, d);
      if (height_m < kLowest_m || height_m > kHighest_m || d * factor < least) continue;
      samples.push_back({static_cast<double>(u), d * factor});
    }
  }
  return samples;
}

bool lies_on(const Fit& fit, const LevelSample& s) {
  return std::abs(fit.at_zero + fit.slope * s.u - s.level) < kTolerance_px;
}

/// A small counter-based generator: the same tries in every run.
std::uint32_t draw(std::uint32_t counter) {
  std::uint32_t x = counter * 0x9E3779B9U + 0x85EBCA6BU;
  x = (x ^ (x >> 16)) * 0x7FEB352DU;
  x = (x ^ (x >> 15)) * 0x846CA68BU;
  return x ^ (x >> 16);
}

Fit best_fit(const std::vector<LevelSample>& samples, double middle_u_px, double reach_px) {
  Fit best;
  const auto n = static_cast<std::uint32_t>(samples.size());
  for (std::uint32_t i = 0; i < kTries; ++i) {
    const LevelSample& a = samples[draw(2 * i) % n];
    const LevelSample& b = samples[draw(2 * i + 1) % n];
    if (std::abs(a.u - b.u) < kLeastWidth_px) continue;
    Fit fit;
    fit.slope = (b.level - a.level) / (b.u - a.u);
    fit.at_zero = a.level - fit.slope * a.u;
    if (std::abs(fit.at_zero + fit.slope * middle_u_px) > reach_px * std::abs(fit.slope)) continue;
    for (const LevelSample& s : samples) fit.inliers += lies_on(fit, s);
    if (fit.inliers > best.inliers) best = fit;
  }
  return best;
}

/// Least squares through the inliers; says over which columns they reach.
Fit polish(const Fit& rough, const std::vector<LevelSample>& samples, double& from_u,
           double& to_u) {
  double n = 0.0;
  double su = 0.0;
  double sl = 0.0;
  double suu = 0.0;
  double sul = 0.0;
  std::vector<double> columns;
  for (const LevelSample& s : samples) {
    if (!lies_on(rough, s)) continue;
    n += 1.0;
    su += s.u;
    sl += s.level;
    suu += s.u * s.u;
    sul += s.u * s.level;
    columns.push_back(s.u);
  }
  std::sort(columns.begin(), columns.end());
  from_u = columns[columns.size() / kTrimmedPart];
  to_u = columns[columns.size() - 1 - columns.size() / kTrimmedPart];
  Fit fit = rough;
  const double spread = n * suu - su * su;
  if (spread > 0.0) {
    fit.slope = (n * sul - su * sl) / spread;
    fit.at_zero = (sl - fit.slope * su) / n;
  }
  return fit;
}

}  // namespace

std::vector<UprightPlane> find_upright_planes(const DisparityMap& map, const ViewGeometry& geometry,
                                              double reach_px) {
  std::vector<UprightPlane> planes;
  std::vector<LevelSample> samples = take_samples(map, geometry);
  const auto total = static_cast<double>(samples.size());
  while (planes.size() < kMostPlanes && samples.size() > kFewestSamples) {
    const Fit rough = best_fit(samples, geometry.centre_u_px(), reach_px);
    if (rough.inliers < kLeastShare * total) break;
    double from_u = 0.0;
    double to_u = 0.0;
    const Fit fit = polish(rough, samples, from_u, to_u);
    std::erase_if(samples, [&](const LevelSample& s) { return lies_on(rough, s); });
    if (to_u - from_u < kLeastWidth_px || fit.slope == 0.0) continue;
    const Point2 a =
        geometry.level_point(from_u, std::max(kFarthestLevel_px, fit.at_zero + fit.slope * from_u));
    const Point2 b =
        geometry.level_point(to_u, std::max(kFarthestLevel_px, fit.at_zero + fit.slope * to_u));
    UprightPlane plane;
    plane.vanishing_u_px = -fit.at_zero / fit.slope;
    plane.share = rough.inliers / total;
    plane.along_m = std::hypot(a.x_m - b.x_m, a.y_m - b.y_m);
    if (plane.along_m >= kLeastAlong_m) planes.push_back(plane);
  }
  return planes;
}

}  // namespace striate::perception
