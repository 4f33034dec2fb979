#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "striate/perception/obstacles/floor_state.hpp"
#include "striate/perception/obstacles/obstacles.hpp"
#include "striate/perception/obstacles/view_geometry.hpp"

namespace striate::perception {
namespace {

/// The threshold stays so much above the floor line: whole-pixel disparities err by as much
constexpr double kFloorMargin_px = 1.0;
constexpr double kPaperConfidence = 0.5;  ///< the paper knows no confidence: undecided

cv::Mat1b threshold_map(const DisparityMap& map, const ViewGeometry& geometry,
                        const ObstacleSettings& settings) {
  cv::Mat1b binary(map.disparity_px.size(), uchar{0});
  for (int v = 0; v < binary.rows; ++v) {
    const double threshold =
        std::max(settings.paper_threshold_px, geometry.floor_disparity_px(v) + kFloorMargin_px);
    for (int u = 0; u < binary.cols; ++u) {
      const float d = map.disparity_px(v, u);
      if (std::isfinite(d) && d > threshold) binary(v, u) = 255;
    }
  }
  return binary;
}

/// A fifth: the part of a blob or column that counts as its nearest (ours)
constexpr std::size_t kFifth = 5;

/// What a fifth of the pixels is nearer than: the nearest part counts, a few wrong pixels do not.
double near_level(std::vector<float>& values) {
  const auto near =
      values.begin() + static_cast<std::ptrdiff_t>(values.size() * (kFifth - 1) / kFifth);
  std::nth_element(values.begin(), near, values.end());
  return *near;
}

struct Blob {
  cv::Rect box;
  int label = 0;
  double level_px = 0.0;  ///< level disparity of its nearest part
};

Obstacle describe_paper_blob(const Blob& blob, const ViewGeometry& geometry) {
  const Point2 left = geometry.level_point(blob.box.x, blob.level_px);
  const Point2 right = geometry.level_point(blob.box.x + blob.box.width - 1.0, blob.level_px);
  const Point2 middle{0.5 * (left.x_m + right.x_m), 0.5 * (left.y_m + right.y_m)};
  Obstacle o;
  o.bearing_rad = std::atan2(middle.y_m, middle.x_m);
  o.distance_m = std::hypot(middle.x_m, middle.y_m);
  o.width_m = std::hypot(left.x_m - right.x_m, left.y_m - right.y_m);
  const double top_d = blob.level_px / geometry.level_factor(blob.box.y);
  o.height_m = std::max(0.0, geometry.height_m(blob.box.y, top_d));
  o.confidence = kPaperConfidence;
  o.from_u_px = blob.box.x;
  o.to_u_px = blob.box.x + blob.box.width - 1;
  return o;
}

std::vector<float> levels_in(const DisparityMap& map, const ViewGeometry& geometry,
                             const cv::Mat1i& labels, const Blob& blob, cv::Range columns) {
  std::vector<float> levels;
  for (int v = blob.box.y; v < blob.box.y + blob.box.height; ++v) {
    for (int u = columns.start; u < columns.end; ++u) {
      if (labels(v, u) != blob.label) continue;
      levels.push_back(static_cast<float>(map.disparity_px(v, u) * geometry.level_factor(v)));
    }
  }
  return levels;
}

std::vector<Column> free_columns(int width, const ViewGeometry& geometry, double threshold_px) {
  std::vector<Column> columns(width);
  for (int u = 0; u < width; ++u) {
    const Point2 end = geometry.level_point(u, threshold_px);
    columns[u].bearing_rad = std::atan2(end.y_m, end.x_m);
    columns[u].free_to_m = std::hypot(end.x_m, end.y_m);
    columns[u].free_confidence = kPaperConfidence;
  }
  return columns;
}

/// Where the line of sight over the blob's top meets the floor again; kNothing_m: nowhere.
double sight_over_blob_m(const ViewGeometry& geometry, const Blob& blob, int u) {
  const double row = blob.box.y - 1.0;
  const double d = geometry.floor_disparity_px(row);
  if (d <= 0.0) return kNothing_m;
  const SpacePoint p = geometry.point(u, row, d);
  return std::hypot(p.x_m, p.y_m);
}

void block_columns(std::vector<Column>& columns, const DisparityMap& map,
                   const ViewGeometry& geometry, const cv::Mat1i& labels, const Blob& blob) {
  for (int u = blob.box.x; u < blob.box.x + blob.box.width; ++u) {
    std::vector<float> levels = levels_in(map, geometry, labels, blob, {u, u + 1});
    if (levels.empty()) continue;
    const Point2 at = geometry.level_point(u, near_level(levels));
    const double distance_m = std::hypot(at.x_m, at.y_m);
    if (distance_m >= columns[u].obstacle_m) continue;
    columns[u].bearing_rad = std::atan2(at.y_m, at.x_m);
    columns[u].obstacle_m = distance_m;
    columns[u].obstacle_confidence = kPaperConfidence;
    columns[u].free_to_m = std::min(columns[u].free_to_m, distance_m);
    hide_behind_obstacle(columns[u], sight_over_blob_m(geometry, blob, u));
  }
}

}  // namespace

ObstacleView find_obstacles_as_in_paper(const DisparityMap& map, const HeadPose& head,
                                        const RobotDescription& robot,
                                        const ObstacleSettings& settings) {
  ObstacleView view;
  if (map.disparity_px.empty()) return view;
  const ViewGeometry geometry(map, head, robot);
  cv::Mat1i labels;
  cv::Mat stats;
  cv::Mat centroids;
  const int count = cv::connectedComponentsWithStats(threshold_map(map, geometry, settings), labels,
                                                     stats, centroids);
  view.columns = free_columns(map.disparity_px.cols, geometry, settings.paper_threshold_px);
  for (int label = 1; label < count; ++label) {
    const int* s = stats.ptr<int>(label);
    if (s[cv::CC_STAT_AREA] < settings.paper_smallest_px) continue;
    Blob blob{
        {s[cv::CC_STAT_LEFT], s[cv::CC_STAT_TOP], s[cv::CC_STAT_WIDTH], s[cv::CC_STAT_HEIGHT]},
        label};
    std::vector<float> levels =
        levels_in(map, geometry, labels, blob, {blob.box.x, blob.box.x + blob.box.width});
    blob.level_px = near_level(levels);
    view.obstacles.push_back(describe_paper_blob(blob, geometry));
    block_columns(view.columns, map, geometry, labels, blob);
  }
  std::stable_sort(
      view.obstacles.begin(), view.obstacles.end(),
      [](const Obstacle& a, const Obstacle& b) { return a.distance_m < b.distance_m; });
  return view;
}

}  // namespace striate::perception
