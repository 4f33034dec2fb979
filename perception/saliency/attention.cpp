#include "striate/perception/saliency/attention.hpp"

#include <algorithm>
#include <cmath>

#include "striate/base/geometry.hpp"

namespace striate::perception {

void Attention::look(const std::vector<SalientRegion>& regions, const ViewShift& shift) {
  // Share of inhibition, after 4.6 times recovery_s: less changes no order that can be seen
  constexpr double kRecovered = 0.01;
  const double decay = std::exp(-std::max(0.0, shift.seconds) / settings_.recovery_s);
  for (Visited& place : visited_) {
    place.inhibition *= decay;
    if (place.inhibition < kRecovered) place.inhibition = 0.0;
    place.bearing_rad = wrap_angle(place.bearing_rad + shift.bearing_rad);
    place.row_px += shift.rows_px;
  }
  regions_ = regions;
}

const SalientRegion* Attention::next() {
  const SalientRegion* best = nullptr;
  double most = settings_.least;
  for (const SalientRegion& region : regions_) {
    const double left = region.salience * (1.0 - inhibition(region));
    if (left > most) {
      most = left;
      best = &region;
    }
  }
  if (best != nullptr) inhibit(*best);
  return best;
}

double Attention::inhibition(const SalientRegion& region) const {
  double strongest = 0.0;
  for (const Visited& place : visited_) {
    if (place.inhibition > strongest && same(place, region)) strongest = place.inhibition;
  }
  return strongest;
}

bool Attention::same(const Visited& place, const SalientRegion& region) const {
  const double apart_rad = std::abs(wrap_angle(place.bearing_rad - region.bearing_rad));
  const double apart_px = std::abs(place.row_px - region.v_px);
  return apart_rad < settings_.same_bearing_rad &&
         apart_px < std::max(settings_.same_height_px, 0.5 * region.height_px);
}

/// The place itself moves to where it is seen now; a new one takes the most recovered entry.
void Attention::inhibit(const SalientRegion& region) {
  Visited* place = nullptr;
  for (Visited& known : visited_) {
    if (known.inhibition > 0.0 && same(known, region)) place = &known;
  }
  if (place == nullptr) {
    place = std::min_element(visited_.begin(), visited_.end(), [](const auto& a, const auto& b) {
      return a.inhibition < b.inhibition;
    });
  }
  *place = {region.bearing_rad, region.v_px, 1.0};
}

}  // namespace striate::perception
