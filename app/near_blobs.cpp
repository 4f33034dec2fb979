#include "striate/app/near_blobs.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "striate/base/index_within.hpp"
#include "striate/perception/perception.hpp"

namespace striate::app {
namespace {

/// px: a smaller disparity errs by half of itself.
constexpr double kLeastSplit_px = 2.0;

/// Otsu's threshold: the split of the known disparities into near and far with the least spread
/// inside both parts. Never below 2 px.
double split_near_from_far(const cv::Mat1f& disparity_px) {
  constexpr int kBins = 1024;       // of kBin_px: 256 px, the most that stereo searches
  constexpr double kBin_px = 0.25;  // px: about the error of a sub-pixel disparity
  // Of the disparities: the share that the split may leave out at the near end (ours)
  constexpr double kOutliers = 0.12;
  double left_out = 0.0;
  std::vector<double> histogram(kBins, 0.0);
  double total = 0.0;
  double sum = 0.0;
  for (const float d : disparity_px) {
    if (!std::isfinite(d)) continue;
    const int bin = cut_within(d / kBin_px, 0, kBins - 1);
    histogram[bin] += 1.0;
    total += 1.0;
    sum += bin;
  }
  const double known = total;
  for (int b = kBins - 1; b >= 0 && left_out < kOutliers * known; --b) {  // wrong matches lie there
    left_out += histogram[b];
    total -= histogram[b];
    sum -= b * histogram[b];
    histogram[b] = 0.0;
  }
  double below = 0.0;
  double below_sum = 0.0;
  double best = -1.0;
  int split = 0;
  for (int b = 0; b < kBins; ++b) {
    below += histogram[b];
    below_sum += b * histogram[b];
    if (below <= 0.0 || below >= total) continue;
    const double gap = below_sum / below - (sum - below_sum) / (total - below);
    const double between = below * (total - below) * gap * gap;
    if (between > best) {
      best = between;
      split = b;
    }
  }
  return std::max(kLeastSplit_px, (split + 1) * kBin_px);
}

/// A camera so high that its floor is below everything: near blobs alone are obstacles.
constexpr double kNoFloor_m = 1e9;

}  // namespace

void find_near_blobs(const PerceiveOptions& o, const StereoFrame& frame, JudgedFrame& judged) {
  perception::Percept& percept = judged.percept;
  judged.robot.camera_height_m = kNoFloor_m;
  perception::ObstacleSettings settings;
  settings.paper_threshold_px =
      o.near_px > 0.0 ? o.near_px : split_near_from_far(percept.disparity.disparity_px);
  perception::DisparityMap map = percept.disparity;
  if (o.focal_px <= 0.0) {  // relative units: one baseline is 1, the view as wide as the robot's
    map.focal_px = 0.5 * map.disparity_px.cols / std::tan(0.5 * judged.robot.view_rad);
    map.baseline_m = 1.0;
    map.centre_u_px = 0.5 * (map.disparity_px.cols - 1);
    map.centre_v_px = 0.5 * (map.disparity_px.rows - 1);
    judged.report.unit = "baselines";
  }
  perception::ObstacleView view =
      perception::find_obstacles_as_in_paper(map, frame.head, judged.robot, settings);
  percept.columns = std::move(view.columns);
  percept.obstacles = std::move(view.obstacles);
  for (perception::Obstacle& obstacle : percept.obstacles)
    obstacle.height_m = 0.0;  // of unknown floor
  percept.disparity.focal_px = map.focal_px;
  percept.disparity.baseline_m = map.baseline_m;
  judged.report.method = "near blobs: threshold on disparity (the paper's)";
  judged.report.threshold_px = settings.paper_threshold_px;
  judged.report.threshold_from = o.near_px > 0.0 ? "given" : "the image (Otsu)";
}

}  // namespace striate::app
