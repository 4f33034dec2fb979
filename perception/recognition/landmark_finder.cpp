#include "striate/perception/recognition/landmark_finder.hpp"

#include <algorithm>
#include <cmath>

#include "striate/perception/recognition/region_depth.hpp"

namespace striate::perception {
namespace {

/// Of the smaller of two boxes: with more in common they show one thing; "a part of the image
/// shows one thing" was chosen on `trial --objects` (ours).
constexpr double kSamePart = 0.5;

/// Where an expected landmark appears, in pixels of the working size; empty: nowhere.
cv::Rect2d box_of(const LandmarkExpectation& expected, const ViewGeometry& geometry) {
  const std::optional<ImagePoint> middle = geometry.project(expected.place);
  if (!middle) return {};
  // d = f B / Z, so that f / Z is d over the baseline.
  const double depth_m = geometry.focal_baseline() / middle->d_px;
  const double half_px = expected.half_m * geometry.focal_px() / depth_m;
  return {middle->u_px - half_px, middle->v_px - half_px, 2 * half_px, 2 * half_px};
}

cv::Rect2d box_of(const Recognition& found) {
  return {found.u_px - found.width_px / 2, found.v_px - found.height_px / 2, found.width_px,
          found.height_px};
}

cv::Rect2d grown(const cv::Rect2d& box, double share) {
  const double du = share * box.width, dv = share * box.height;
  return {box.x - du, box.y - dv, box.width + 2 * du, box.height + 2 * dv};
}

cv::Rect2d zoomed(const cv::Rect2d& box, double zoom) {
  return {(box.x + 0.5) * zoom - 0.5, (box.y + 0.5) * zoom - 0.5, box.width * zoom,
          box.height * zoom};
}

double distance_m(const SpacePoint& point) {
  return std::hypot(point.x_m, point.y_m);
}

}  // namespace

LandmarkFinder::LandmarkFinder(const LandmarkFinderSettings& settings,
                               std::span<const KnownView> views, const Clock* clock)
    : settings_(settings), recogniser_(settings.matching), clock_(clock) {
  landmark_of_view_.reserve(views.size());
  for (const KnownView& known : views) {
    recogniser_.add(known.landmark, known.view);
    landmark_of_view_.push_back(known.landmark);
  }
}

LandmarkLook LandmarkFinder::find(const cv::Mat1b& grey, const ViewGeometry& geometry,
                                  const Percept& percept, const LandmarkExpectations& expected) {
  LandmarkLook look;
  if (views() == 0 || pictures_++ % settings_.every != 0) return look;
  choose_windows(grey, geometry, percept, expected.places);
  choose_views(expected.views);
  gather_keypoints(grey);
  keep_one_a_place(compare(), look.recognitions);
  for (Recognition& found : look.recognitions) place(geometry, percept.disparity, found);
  const auto seen = [&](int landmark) {
    return std::ranges::any_of(
        look.recognitions, [&](const Recognition& found) { return found.landmark == landmark; });
  };
  for (const LandmarkExpectation& one : expected.places) {
    const LookResult result =
        seen(one.landmark) ? LookResult::found : judge(one, geometry, percept, expected.views);
    look.expected.push_back({one.landmark, result});
  }
  return look;
}

void LandmarkFinder::choose_windows(const cv::Mat1b& grey, const ViewGeometry& geometry,
                                    const Percept& percept,
                                    std::span<const LandmarkExpectation> expected_places) {
  const int working_px = percept.saliency.salience.cols;
  zoom_ = working_px > 0 ? static_cast<double>(grey.cols) / working_px : 1.0;
  windows_.begin(grey.size(), settings_.most_windows);
  expected_.clear();
  if (geometry.focal_baseline() > 0.0) {
    for (const LandmarkExpectation& expected : expected_places) {
      // Twice as large: memory's place is not exact.
      const cv::Rect2d around = zoomed(grown(box_of(expected, geometry), 0.5), zoom_);
      windows_.add(around);
      expected_.push_back({expected.landmark, around});
    }
  }
  for (const SalientRegion& region : percept.saliency.regions) {
    const cv::Rect2d box(region.u_px - region.width_px / 2, region.v_px - region.height_px / 2,
                         region.width_px, region.height_px);
    windows_.add(zoomed(grown(box, settings_.margin), zoom_));
  }
}

/// Keypoints of all windows, in pixels of the image, each once.
void LandmarkFinder::gather_keypoints(const cv::Mat1b& grey) {
  keypoints_.clear();
  for (std::size_t k = 0; k < windows_.windows().size(); ++k) {
    const LookWindow& window = windows_.windows()[k];
    auto& oriented = keypoints_of_size_[static_cast<std::size_t>(window.size)];
    if (!oriented) oriented = std::make_unique<OrientedKeypoints>(OrientedSettings{});
    oriented->find(grey(window.part), in_window_);
    for (Keypoint point : in_window_) {
      point.u_px += window.part.x;
      point.v_px += window.part.y;
      if (!windows_.covered(point.u_px, point.v_px, k)) keypoints_.push_back(point);
    }
  }
}

void LandmarkFinder::choose_views(std::span<const int> order) {
  const auto most = static_cast<std::size_t>(settings_.most_views);
  const std::span<const int> first = order.first(std::min(most, order.size()));
  chosen_.assign(first.begin(), first.end());
  if (order.size() <= most) return;
  const std::size_t always = most * 3 / 4, others = order.size() - always;
  for (std::size_t k = always; k < most; ++k) chosen_[k] = order[always + turn_++ % others];
}

const std::vector<Recognition>& LandmarkFinder::compare() {
  RecognitionBudget budget;
  if (clock_ != nullptr && settings_.most_time_s > 0.0) {
    budget.goes_on = [clock = clock_, ends = clock_->now() + from_seconds(settings_.most_time_s)] {
      return clock->now() < ends;
    };
  }
  return recogniser_.recognise(keypoints_, chosen_, budget, expected_);
}

/// A part of the image shows one thing: what has most inliers there. Others that have something
/// in common with it, such as the same label, give way.
void LandmarkFinder::keep_one_a_place(const std::vector<Recognition>& found,
                                      std::vector<Recognition>& kept) const {
  kept.clear();
  for (const Recognition& one : found) {  // most inliers first
    const bool taken = std::ranges::any_of(kept, [&](const Recognition& stronger) {
      const cv::Rect2d a = box_of(one), b = box_of(stronger);
      return (a & b).area() > kSamePart * std::min(a.area(), b.area());
    });
    if (!taken) kept.push_back(one);
  }
}

/// Bearing by the place in the image, distance by the disparity in its middle half.
void LandmarkFinder::place(const ViewGeometry& geometry, const DisparityMap& map,
                           Recognition& found) {
  if (geometry.focal_px() <= 0.0) return;
  const double u_px = (found.u_px + 0.5) / zoom_ - 0.5, v_px = (found.v_px + 0.5) / zoom_ - 0.5;
  found.bearing_rad = geometry.ray_bearing_rad(u_px);
  const double width_px = found.width_px / zoom_ / 2, height_px = found.height_px / zoom_ / 2;
  const double disparity_px = median_disparity_px(
      map, {u_px - width_px / 2, v_px - height_px / 2, width_px, height_px}, disparities_);
  if (disparity_px <= 0.0 || geometry.focal_baseline() <= 0.0) return;
  const SpacePoint point = geometry.point(u_px, v_px, disparity_px);
  found.bearing_rad = std::atan2(point.y_m, point.x_m);
  found.distance_m = distance_m(point);
  found.height_m = point.z_m;
}

/// Why an expected landmark was not recognised.
LookResult LandmarkFinder::judge(const LandmarkExpectation& expected, const ViewGeometry& geometry,
                                 const Percept& percept, std::span<const int> order) {
  const cv::Size size = percept.disparity.disparity_px.size();
  const cv::Rect2d box = box_of(expected, geometry);
  const double away_m = distance_m(expected.place);
  const bool whole = box.area() > 0.0 && box.x >= 0.0 && box.y >= 0.0 &&
                     box.x + box.width <= size.width - 1 && box.y + box.height <= size.height - 1;
  if (!whole || away_m > settings_.farthest_m || percept.light_level < settings_.least_light) {
    return LookResult::out_of_view;
  }
  const double u_px = box.x + box.width / 2, v_px = box.y + box.height / 2;
  const double there_px = median_disparity_px(percept.disparity, box, disparities_);
  if (there_px > 0.0) {
    const double nearest_m = distance_m(geometry.point(u_px, v_px, there_px));
    if (nearest_m < away_m - settings_.hidden_by_m) return LookResult::hidden;
  }
  const bool looked_at = windows_.covered((u_px + 0.5) * zoom_ - 0.5, (v_px + 0.5) * zoom_ - 0.5,
                                          windows_.windows().size());
  return looked_at && compared(expected.landmark, order) ? LookResult::missed
                                                         : LookResult::not_looked_for;
}

/// Whether all its views that are looked for were compared with this image.
bool LandmarkFinder::compared(int landmark, std::span<const int> order) const {
  const auto is_of_it = [&](int view) {
    return landmark_of_view_[static_cast<std::size_t>(view)] == landmark;
  };
  const auto compared = static_cast<std::ptrdiff_t>(recogniser_.looked_at());
  const auto done = std::count_if(chosen_.begin(), chosen_.begin() + compared, is_of_it);
  return done > 0 && done == std::ranges::count_if(order, is_of_it);
}

}  // namespace striate::perception
