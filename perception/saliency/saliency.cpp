#include "perception/saliency/saliency.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "perception/saliency/blob_response.hpp"

namespace striate {
namespace {

cv::Mat1f near_disparity(const DisparityMap& map, cv::Size half, const SaliencySettings& settings) {
  cv::Mat1f near(map.disparity_px.size(), 0.0F);
  for (int v = 0; v < near.rows; ++v) {
    for (int u = 0; u < near.cols; ++u) {
      const float d = map.disparity_px(v, u);
      if (std::isfinite(d) && d > settings.near_px) {
        near(v, u) = static_cast<float>(settings.near_gain) * d;
      }
    }
  }
  cv::resize(near, near, half, 0, 0, cv::INTER_AREA);
  return near;
}

cv::Mat1f sum_of_maps(const cv::Mat3b& picture, const DisparityMap& map,
                      const SaliencySettings& settings) {
  const cv::Size half((picture.cols + 1) / 2, (picture.rows + 1) / 2);
  cv::Mat small;
  cv::resize(picture, small, half, 0, 0, cv::INTER_AREA);
  small.convertTo(small, CV_32FC3, 1.0 / 255.0);
  cv::cvtColor(small, small, cv::COLOR_BGR2Lab);
  std::vector<cv::Mat1f> lab;
  cv::split(small, lab);
  cv::Mat1f sum(half, 0.0F);
  for (const cv::Mat1f& plane : lab) add_blob_response(plane, Rectify::both, sum);
  if (!map.disparity_px.empty()) {
    add_blob_response(near_disparity(map, half, settings), Rectify::half, sum);
  }
  cv::resize(sum, sum, picture.size(), 0, 0, cv::INTER_LINEAR);
  return sum;
}

double median_disparity(const DisparityMap& map, const cv::Mat1i& labels, int label, cv::Rect box) {
  std::vector<float> values;
  if (map.disparity_px.empty()) return 0.0;
  for (int v = box.y; v < box.y + box.height; ++v) {
    for (int u = box.x; u < box.x + box.width; ++u) {
      const float d = map.disparity_px(v, u);
      if (labels(v, u) == label && std::isfinite(d) && d > 0.0F) values.push_back(d);
    }
  }
  // A tenth of the region must be known, else the distance would be that of a stray pixel.
  if (values.empty() || values.size() * 10 < static_cast<std::size_t>(box.area())) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

SalientRegion describe(const SaliencyMap& map, cv::Rect box, const cv::Mat1b& mask,
                       const ViewGeometry& geometry, double disparity_px) {
  SalientRegion region;
  region.u_px = box.x + 0.5 * (box.width - 1);
  region.v_px = box.y + 0.5 * (box.height - 1);
  region.width_px = box.width;
  region.height_px = box.height;
  cv::minMaxLoc(map.salience(box), nullptr, &region.salience, nullptr, nullptr, mask);
  if (geometry.focal_px() > 0.0) region.bearing_rad = geometry.ray_bearing_rad(region.u_px);
  if (disparity_px > 0.0 && geometry.focal_baseline() > 0.0) {
    const SpacePoint p = geometry.point(region.u_px, region.v_px, disparity_px);
    region.distance_m = std::hypot(p.x_m, p.y_m);
    region.bearing_rad = std::atan2(p.y_m, p.x_m);
  }
  return region;
}

}  // namespace

SaliencyMap find_salience(const cv::Mat3b& picture, const DisparityMap& map,
                          const ViewGeometry& geometry, const SaliencySettings& settings) {
  SaliencyMap result;
  if (picture.empty()) return result;
  result.salience = sum_of_maps(picture, map, settings);
  double highest = 0.0;
  cv::minMaxLoc(result.salience, nullptr, &highest);
  const double scale = std::max(highest, settings.least_contrast);
  if (scale > 0.0) result.salience *= 1.0 / scale;

  cv::Mat1i labels;
  cv::Mat stats;
  cv::Mat centroids;
  const int count = cv::connectedComponentsWithStats(result.salience >= settings.threshold, labels,
                                                     stats, centroids);
  for (int label = 1; label < count; ++label) {
    const int* s = stats.ptr<int>(label);
    if (s[cv::CC_STAT_AREA] < settings.smallest_px) continue;
    const cv::Rect box(s[cv::CC_STAT_LEFT], s[cv::CC_STAT_TOP], s[cv::CC_STAT_WIDTH],
                       s[cv::CC_STAT_HEIGHT]);
    const cv::Mat1b mask = labels(box) == label;
    result.regions.push_back(
        describe(result, box, mask, geometry, median_disparity(map, labels, label, box)));
  }
  std::stable_sort(
      result.regions.begin(), result.regions.end(),
      [](const SalientRegion& a, const SalientRegion& b) { return a.salience > b.salience; });
  const auto most = static_cast<std::size_t>(settings.most_regions);
  if (result.regions.size() > most) result.regions.resize(most);
  return result;
}

}  // namespace striate
