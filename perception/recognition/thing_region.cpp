#include "striate/perception/recognition/thing_region.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "striate/base/index_within.hpp"

namespace striate::perception {
namespace {

/// 11 deg: a region farther from the line of sight is another thing; the servos err by less
constexpr double kAimed_rad = 0.2;
/// One px of disparity is 0.37 m there: beyond, a thing is not cut from its background
constexpr double kFarthestThing_m = 3.0;
/// How far a thing reaches before and behind its middle: boxes, cups, books (ours)
constexpr double kDeep_m = 0.12;
/// Of its side: a region, cut at half its salience, may be a little smaller than its thing
constexpr double kGrown = 0.15;
constexpr int kLeastPixels = 20;  // at width 160: a thing of 5 cm at 2 m is 5 x 5 px

/// Nearest in direction; nullptr where there is none.
const SalientRegion* region_at(const Percept& percept, double bearing_rad) {
  const SalientRegion* best = nullptr;
  double least_rad = kAimed_rad;
  for (const SalientRegion& region : percept.saliency.regions) {
    if (!(region.distance_m < kFarthestThing_m)) continue;
    const double off_rad = std::abs(wrap_angle(region.bearing_rad - bearing_rad));
    if (off_rad >= least_rad) continue;
    least_rad = off_rad;
    best = &region;
  }
  return best;
}

cv::Rect grown_box(const SalientRegion& region, cv::Size size) {
  const double width = region.width_px * (1 + 2 * kGrown);
  const double height = region.height_px * (1 + 2 * kGrown);
  const cv::Rect box(nearest_cell(region.u_px - width / 2), nearest_cell(region.v_px - height / 2),
                     nearest_cell(width) + 1, nearest_cell(height) + 1);
  return box & cv::Rect({0, 0}, size);
}

/// Disparity of most of the middle half of a box; 0: not known.
float disparity_of(const cv::Mat1f& disparity, const cv::Rect& box) {
  std::vector<float> known;
  const cv::Rect middle(box.x + box.width / 4, box.y + box.height / 4, std::max(1, box.width / 2),
                        std::max(1, box.height / 2));
  for (const float d : cv::Mat1f(disparity(middle).clone())) {
    if (std::isfinite(d) && d > 0.0F) known.push_back(d);
  }
  if (known.empty()) return 0.0F;
  const auto half = known.begin() + static_cast<std::ptrdiff_t>(known.size() / 2);
  std::nth_element(known.begin(), half, known.end());
  return *half;
}

/// Of what lies within the box at the disparity, the largest connected part.
cv::Mat1b cut_by_disparity(const cv::Mat1f& disparity, const cv::Rect& box, double middle_px,
                           double tolerance_px) {
  cv::Mat1b mask(disparity.size(), std::uint8_t{0});
  for (int v = box.y; v < box.y + box.height; ++v) {
    for (int u = box.x; u < box.x + box.width; ++u) {
      mask(v, u) = std::abs(disparity(v, u) - middle_px) <= tolerance_px ? 255 : 0;
    }
  }
  cv::Mat1i labels;
  cv::Mat stats, centroids;
  const int count = cv::connectedComponentsWithStats(mask, labels, stats, centroids, 4);
  int largest = 0;
  for (int label = 1; label < count; ++label) {
    const bool larger = largest == 0 || stats.at<int>(label, cv::CC_STAT_AREA) >
                                            stats.at<int>(largest, cv::CC_STAT_AREA);
    if (larger) largest = label;
  }
  return largest == 0 ? cv::Mat1b(disparity.size(), std::uint8_t{0}) : cv::Mat1b(labels == largest);
}

}  // namespace

std::optional<ThingRegion> find_thing(const Percept& percept, const ViewGeometry& geometry,
                                      double bearing_rad) {
  const cv::Mat1f& disparity = percept.disparity.disparity_px;
  const SalientRegion* region = region_at(percept, bearing_rad);
  if (region == nullptr || disparity.empty() || geometry.focal_baseline() <= 0.0) return {};
  const cv::Rect box = grown_box(*region, disparity.size());
  if (box.area() < kLeastPixels) return {};
  const double middle_px = disparity_of(disparity, box);
  if (middle_px <= 0.0) return {};
  // d = f B / Z, so that a step of depth changes it by d^2 / (f B).
  const double tolerance_px =
      std::max(1.0, kDeep_m * middle_px * middle_px / geometry.focal_baseline());
  ThingRegion thing;
  thing.mask = cut_by_disparity(disparity, box, middle_px, tolerance_px);
  if (cv::countNonZero(thing.mask) < kLeastPixels) return {};
  // Small gaps in the disparity are gaps in what was measured, not in the thing.
  cv::morphologyEx(thing.mask, thing.mask, cv::MORPH_CLOSE, cv::Mat1b(5, 5, std::uint8_t{1}));
  thing.box = cv::boundingRect(thing.mask);
  const SpacePoint middle = geometry.point(thing.box.x + 0.5 * (thing.box.width - 1),
                                           thing.box.y + 0.5 * (thing.box.height - 1), middle_px);
  thing.bearing_rad = std::atan2(middle.y_m, middle.x_m);
  thing.distance_m = std::hypot(middle.x_m, middle.y_m);
  thing.height_m = middle.z_m;
  return thing;
}

cv::Rect full_size_box(const ThingRegion& thing, cv::Size image) {
  const double zoom = static_cast<double>(image.width) / thing.mask.cols;
  const cv::Rect box(nearest_cell(thing.box.x * zoom), nearest_cell(thing.box.y * zoom),
                     nearest_cell(thing.box.width * zoom), nearest_cell(thing.box.height * zoom));
  return box & cv::Rect({0, 0}, image);
}

LandmarkView view_of_thing(const cv::Mat1b& grey, const ThingRegion& thing,
                           const KeypointSource& find) {
  const cv::Rect box = full_size_box(thing, grey.size());
  const double zoom = static_cast<double>(grey.cols) / thing.mask.cols;
  // As much around it as the finder adds, so that keypoints at its rim are the same ones.
  const int margin = std::max(box.width, box.height) / 4;
  const cv::Rect around =
      cv::Rect(box.x - margin, box.y - margin, box.width + 2 * margin, box.height + 2 * margin) &
      cv::Rect({0, 0}, grey.size());
  LandmarkView all =
      make_view(grey(around), {box.x - around.x, box.y - around.y, box.width, box.height}, find);
  LandmarkView view;
  view.width_px = all.width_px;
  view.height_px = all.height_px;
  for (std::size_t k = 0; k < all.keypoints.size(); ++k) {
    const ViewKeypoint& point = all.keypoints[k];
    const int u = cut_within((box.x + point.x_px) / zoom, 0, thing.mask.cols - 1);
    const int v = cut_within((box.y + point.y_px) / zoom, 0, thing.mask.rows - 1);
    if (thing.mask(v, u) == 0) continue;
    view.keypoints.push_back(point);
    view.descriptors.push_back(all.descriptors[k]);
  }
  return view;
}

}  // namespace striate::perception
