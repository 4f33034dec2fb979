#include "striate/agent/pictures/label_places.hpp"

#include <algorithm>
#include <cmath>

#include "striate/base/geometry.hpp"
#include "striate/base/index_within.hpp"

namespace striate::agent::pictures {
namespace {

// By hand: beside a thing, not across the picture.
constexpr int kRings = 9;
constexpr int kRing_px = 10;
constexpr int kDirections = 16;

}  // namespace

cv::Rect LabelPlaces::take(cv::Point anchor, cv::Size label) {
  const cv::Rect picture({}, taken_.size());
  label = {std::min(label.width, picture.width), std::min(label.height, picture.height)};
  cv::Rect best;
  int least = -1;
  for (int ring = 1; ring <= kRings; ++ring) {
    for (int k = 0; k < kDirections; ++k) {
      // The label's nearest edge lies on the ring, so that long words do not lie farther off.
      const double angle_rad = 2.0 * kPi * k / kDirections - kPi / 2.0;
      const double reach_u = ring * kRing_px + label.width / 2.0;
      const double reach_v = ring * kRing_px + label.height / 2.0;
      const cv::Point middle(anchor.x + nearest_cell(reach_u * std::cos(angle_rad)),
                             anchor.y + nearest_cell(reach_v * std::sin(angle_rad)));
      cv::Rect place(middle - cv::Point(label.width / 2, label.height / 2), label);
      place.x = std::clamp(place.x, 0, picture.width - label.width);
      place.y = std::clamp(place.y, 0, picture.height - label.height);
      const int cost = cv::countNonZero(taken_(place)) * kRings + ring;
      if (least >= 0 && cost >= least) continue;
      least = cost;
      best = place;
    }
  }
  taken_(best).setTo(255);
  return best;
}

}  // namespace striate::agent::pictures
