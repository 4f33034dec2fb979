#include "striate/perception/corridor/wall_profile.hpp"

#include <algorithm>
#include <array>
#include <bitset>
#include <cmath>

#include "striate/base/index_within.hpp"

namespace striate::perception {
namespace {

/// Confidence: all promises (0.5 and more) pass; of scores of 0.4 73 % are right (confidence_fit)
constexpr double kProfileTrusted = 0.4;
/// Above the floor: what one px of disparity is worth in height 3 m away (1.2 m / 8.1 px)
constexpr double kProfileLowest_m = 0.15;
constexpr double kProfileHighest_m =
    2.6;  // just below the ceiling of the shipped corridors (2.7 m)
/// Beyond, one pixel of disparity is more than 1.7 m (Z^2 / f B at width 160)
constexpr double kProfileFarthest_m = 6.5;
constexpr double kNearestProfile_m =
    0.25;  // no wall passes through the robot, whose radius is 0.25 m
/// The distance error of one px 1.1 m away (Z^2 / f B at width 160)
constexpr double kSideBin_m = 0.05;
/// Walls of a hall 8 m wide; farther ones are not looked for (ours)
constexpr double kFarthestSide_m = 4.0;
constexpr int kSideBins = 80;  // per side: kFarthestSide_m / kSideBin_m
/// Along the wall; a depth error at 2.5 m, where one px is 0.26 m
constexpr double kAlongCell_m = 0.25;
constexpr double kUpCell_m = 0.3;  // upwards; a height error at 6 m, where one px is 0.3 m
constexpr int kAlongCells = 32;    // 8 m: beyond kProfileFarthest_m nothing is collected
constexpr int kUpCells = 9;        // 2.7 m: up to above kProfileHighest_m
/// Bins to either side that are the same wall: 0.25 m in all, a depth error at 2.5 m
constexpr int kProfileWindow = 2;
/// Cells of 0.075 m2: about 1 m2 of wall, more than a box or a person shows (ours)
constexpr double kLeastStructure = 14.0;
constexpr double kProfileLeastAlong_m = 1.0;  // longer than a chair or a person is deep (ours)
/// Of the strongest: a wall half hidden by furniture still shows half of itself (ours)
constexpr double kNearlyMost = 0.5;

using Cells = std::bitset<kAlongCells * kUpCells>;
using Profile = std::array<Cells, kSideBins>;

Cells window_cells(const Profile& profile, int bin) {
  Cells cells;
  const int last = std::min(kSideBins - 1, bin + kProfileWindow);
  for (int b = std::max(0, bin - kProfileWindow); b <= last; ++b) cells |= profile[b];
  return cells;
}

/// The lowest cell of every length of the corridor.
Cells lowest_cells() {
  Cells lowest;
  for (int a = 0; a < kAlongCells; ++a) lowest.set(static_cast<std::size_t>(a) * kUpCells);
  return lowest;
}

/// All nine cells above one another are gathered in the lowest of them, for all lengths at once.
double length_along(const Cells& cells) {
  static_assert(kUpCells == 9);
  static const Cells kLowest = lowest_cells();  // the lowest of each column of cells, as a mask
  const Cells pairs = cells | (cells >> 1);
  const Cells fours = pairs | (pairs >> 2);
  const Cells column = fours | (fours >> 4) | (cells >> 8);
  return static_cast<double>((column & kLowest).count()) * kAlongCell_m;
}

/// `sides`: signed distances to the wall's side of the points, to find the wall's middle.
Wall strongest_wall(const Profile& profile, const std::vector<float>& sides) {
  std::array<double, kSideBins> structure{};
  std::array<double, kSideBins> along_m{};
  double most = 0.0;
  for (int bin = 0; bin < kSideBins; ++bin) {
    const Cells cells = window_cells(profile, bin);
    along_m[bin] = length_along(cells);
    if (along_m[bin] < kProfileLeastAlong_m) continue;
    structure[bin] = static_cast<double>(cells.count());
    most = std::max(most, structure[bin]);
  }
  if (most < kLeastStructure) return {};
  // The outermost of the strong ones: furniture and people stand inside the walls.
  int best = kSideBins - 1;
  while (structure[best] < kNearlyMost * most) --best;
  while (best > 0 && structure[best - 1] >= structure[best]) --best;
  Wall wall{kNothing_m, structure[best], along_m[best]};
  const double middle_m = (best + 0.5) * kSideBin_m;
  double sum = 0.0;
  int count = 0;
  for (const float side_m : sides) {
    if (std::abs(side_m - middle_m) > (kProfileWindow + 0.5) * kSideBin_m) continue;
    sum += side_m;
    ++count;
  }
  wall.distance_m = count > 0 ? sum / count : middle_m;
  return wall;
}

}  // namespace

std::vector<SpacePoint> collect_wall_points(const DisparityMap& map, const ViewGeometry& geometry) {
  std::vector<SpacePoint> points;
  const double least_px = geometry.focal_baseline() / kProfileFarthest_m;
  for (int v = 0; v < map.disparity_px.rows; ++v) {
    for (int u = (v & 1); u < map.disparity_px.cols; u += 2) {  // half of them, as a checkerboard
      const float d = map.disparity_px(v, u);
      if (!(map.confidence(v, u) >= kProfileTrusted) || !std::isfinite(d) || d < least_px) continue;
      const SpacePoint p = geometry.point(u, v, d);
      if (p.z_m > kProfileLowest_m && p.z_m < kProfileHighest_m) points.push_back(p);
    }
  }
  return points;
}

Walls find_walls(const std::vector<SpacePoint>& points, double heading_rad) {
  const double c = std::cos(heading_rad);
  const double s = std::sin(heading_rad);
  Profile left{};
  Profile right{};
  std::vector<float> left_sides;
  std::vector<float> right_sides;
  for (const SpacePoint& p : points) {
    const double along_m = c * p.x_m + s * p.y_m;
    const double side_m = c * p.y_m - s * p.x_m;
    const double distance_m = std::abs(side_m);
    // Said so that what is no number is no wall.
    if (!(along_m >= 0.0 && distance_m >= kNearestProfile_m && distance_m < kFarthestSide_m))
      continue;
    const int along = cut_within(along_m / kAlongCell_m, 0, kAlongCells);
    const int up = cut_within(p.z_m / kUpCell_m, -1, kUpCells);
    if (along >= kAlongCells || up < 0 || up >= kUpCells) continue;
    const int bin = cut_within(distance_m / kSideBin_m, 0, kSideBins - 1);
    (side_m > 0.0 ? left : right)[bin].set(static_cast<std::size_t>(along * kUpCells + up));
    (side_m > 0.0 ? left_sides : right_sides).push_back(static_cast<float>(distance_m));
  }
  return {strongest_wall(left, left_sides), strongest_wall(right, right_sides)};
}

}  // namespace striate::perception
