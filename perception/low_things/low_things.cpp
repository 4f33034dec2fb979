#include "striate/perception/low_things/low_things.hpp"

#include <algorithm>
#include <cmath>

#include "striate/perception/low_things/floor_refuted.hpp"
#include "striate/perception/stereo/row_offset.hpp"
#include "striate/perception/stereo/stereo_matcher.hpp"

namespace striate::perception {
namespace {

/// Disparity that the floor gets in the band, px: mirror images in it are farther
constexpr double kFloorAt_px = 6.0;
/// Disparities searched: up to 18 px above the floor line, 0.4 m high 1 m away
constexpr int kBandCandidates = 24;
constexpr int kFewestRows = 24;  // rows; fewer show nothing that the paths could smooth (ours)
/// Px of the finer size: a low thing may be missed at the working size (one px and a half of it)
constexpr double kApart_px = 3.0;
constexpr float kBandTrusted = 0.3F;  // confidence, as ObstacleSettings::trusted
/// Two sides of one low thing whose front and top are plain: as far away as each other, m ...
constexpr double kSameFront_m = 0.12;
/// ... and no farther apart than the robot is wide (0.425 m), which passes between no two things
constexpr double kOneThing_m = 0.42;
/// Confidence of what lies between, of the weaker side's (as kBridgedCounts of obstacles.cpp)
constexpr double kBetween = 0.5;
/// Rows above the band's own: the reach of V1's filter of 3 px and of the descriptor
constexpr int kMarginRows = 6;

StereoSettings band_stereo(StereoSettings stereo) {
  stereo.mode = StereoMode::robust;
  stereo.width *= kFinerSize;
  stereo.candidates = kBandCandidates;
  stereo.robust.fine_greys = true;
  stereo.robust.align_rows = false;  // known from the working size
  stereo.robust.fill_gap_px = 0;     // what was not seen says nothing about a few centimetres
  return stereo;
}

void describe_band(const DisparityMap& coarse, int first_row, DisparityMap& fine) {
  fine.focal_px = kFinerSize * coarse.focal_px;
  fine.centre_u_px = kFinerSize * (coarse.centre_u_px + 0.5) - 0.5;
  fine.centre_v_px = kFinerSize * (coarse.centre_v_px + 0.5) - 0.5 - first_row;
  fine.baseline_m = coarse.baseline_m;
}

void bridge_plain_fronts(std::vector<Column>& columns) {
  std::size_t left = columns.size();
  for (std::size_t right = 0; right < columns.size(); ++right) {
    const Column& b = columns[right];
    if (!std::isfinite(b.obstacle_m)) continue;
    const bool gap = left < right && right - left > 1;
    if (gap) {
      const Column a = columns[left];
      const double apart_m = b.obstacle_m * std::abs(a.bearing_rad - b.bearing_rad);
      const bool one =
          std::abs(a.obstacle_m - b.obstacle_m) < kSameFront_m && apart_m < kOneThing_m;
      for (std::size_t u = left + 1; one && u < right; ++u) {
        Column& between = columns[u];
        const double share = static_cast<double>(u - left) / static_cast<double>(right - left);
        between.obstacle_m = a.obstacle_m + share * (b.obstacle_m - a.obstacle_m);
        between.obstacle_confidence =
            kBetween * std::min(a.obstacle_confidence, b.obstacle_confidence);
        between.hidden_from_m = between.obstacle_m;
        between.hidden_to_m = std::max(a.hidden_to_m, b.hidden_to_m);
      }
    }
    left = right;
  }
}

}  // namespace

LowThingFinder::LowThingFinder(const LowThingSettings& settings, const StereoSettings& stereo,
                               const RobotDescription& robot)
    : settings_(settings),
      robot_(robot),
      width_px_(kFinerSize * stereo.width),
      matcher_(band_stereo(stereo)) {}

/// From the row in which the highest thing at the farthest distance begins to the bottom.
int LowThingFinder::first_row_of(const ViewGeometry& geometry, int rows) const {
  const double least_fall = (robot_.camera_height_m - settings_.highest_m) / settings_.farthest_m;
  for (int v = 0; v < rows; ++v) {
    if (geometry.level_factor(v) > 0.0 && geometry.fall_of_row(v) >= least_fall) {
      return std::max(0, v - kMarginRows);
    }
  }
  return rows;
}

DisparityMap LowThingFinder::measure(const StereoFrame& frame, const cv::Mat1b& left,
                                     const DisparityMap& coarse) {
  DisparityMap fine;
  if (!settings_.on || left.cols < width_px_ || coarse.focal_px <= 0.0) return fine;
  if (robot_.camera_height_m <= settings_.highest_m) return fine;
  const cv::Mat1w left_fine = to_fine_working_size(left, width_px_);
  describe_band(coarse, 0, fine);
  const ViewGeometry geometry(fine, frame.head, robot_);
  const int first_row = first_row_of(geometry, left_fine.rows);
  if (left_fine.rows - first_row < kFewestRows) return fine;
  cv::Mat1w right_fine = to_fine_working_size(frame.right, width_px_);
  if (coarse.right_lower_px != 0.0) {
    right_fine = raised(right_fine, kFinerSize * coarse.right_lower_px);
  }
  const FloorBand band = cut_floor_band(left_fine, right_fine, geometry, first_row, kFloorAt_px);
  matcher_.match(band.left, band.right, fine);
  describe_band(coarse, band.first_row, fine);
  trust_only_what_agrees(band, coarse, fine);
  return fine;
}

/// Few disparities were searched, so what stands higher than they reach has found a wrong one: the
/// working size, which searches all, knows better. And a pixel above the floor says something only
/// if the floor does not explain it as well.
void LowThingFinder::trust_only_what_agrees(const FloorBand& band, const DisparityMap& coarse,
                                            DisparityMap& fine) const {
  const FloorRefutation refutation(band, kFloorAt_px);
  for (int row = 0; row < fine.disparity_px.rows; ++row) {
    const int coarse_row =
        std::min(coarse.disparity_px.rows - 1, (band.first_row + row) / kFinerSize);
    for (int u = 0; u < fine.disparity_px.cols; ++u) {
      float& d = fine.disparity_px(row, u);
      if (d == kNoMatch) continue;
      const float in_band = d;
      d += static_cast<float>(band.moved_px[static_cast<std::size_t>(row)]);
      const int coarse_u = std::min(coarse.disparity_px.cols - 1, u / kFinerSize);
      const float expected = kFinerSize * coarse.disparity_px(coarse_row, coarse_u);
      const bool known = coarse.confidence(coarse_row, coarse_u) >= kBandTrusted;
      const bool in_both = d > 0.0F && d <= static_cast<float>(u);
      const bool agrees = in_both && known && std::abs(expected - d) <= kApart_px;
      const bool above = in_band > kFloorAt_px + settings_.floor_margin_px;
      if (agrees && (!above || refutation.at(row, u, in_band) >= settings_.refuted)) continue;
      d = kNoMatch;
      fine.confidence(row, u) = 0.0F;
    }
  }
}

ObstacleView LowThingFinder::judge(const DisparityMap& fine, const HeadPose& head) const {
  ObstacleSettings rules;
  rules.lowest_m = settings_.lowest_m;
  rules.highest_m = settings_.highest_m;
  rules.farthest_m = settings_.farthest_m;
  rules.farthest_floor_m = settings_.farthest_m;
  rules.floor_margin_px = settings_.floor_margin_px;
  rules.standing_px = settings_.standing_px;
  rules.smallest_m = settings_.smallest_m;
  rules.smallest_px = settings_.smallest_px;
  rules.floor_offset_px = kFinerSize * ObstacleSettings{}.floor_offset_px;
  rules.bridged_columns = 0;  // it would bridge to things that stand farther off, too
  ObstacleView view = find_obstacles(fine, head, robot_, rules);
  bridge_plain_fronts(view.columns);
  return view;
}

}  // namespace striate::perception
