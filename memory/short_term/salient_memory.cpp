#include "striate/memory/short_term/salient_memory.hpp"

#include <algorithm>
#include <cmath>

namespace striate::memory {
namespace {

// By hand, a factor of 1.6 in the range: ranges are noisy, only a clear difference tells two things
// apart. SalientMemory.TheSameBearingAtAnotherDistanceIsAnotherThing.
constexpr double kAnotherRange = 0.47;  // its natural logarithm

}  // namespace

void SalientMemory::move(const Pose2& before, const Pose2& after) {
  for (RememberedRegion& region : regions_) {
    if (!region.used) continue;
    if (!std::isfinite(region.distance_m)) {
      region.bearing_rad = wrap_angle(region.bearing_rad + before.heading_rad - after.heading_rad);
      continue;
    }
    const Point2 place = inverse_transform(
        after, transform(before, Point2{region.distance_m * std::cos(region.bearing_rad),
                                        region.distance_m * std::sin(region.bearing_rad)}));
    region.bearing_rad = std::atan2(place.y_m, place.x_m);
    region.distance_m = std::hypot(place.x_m, place.y_m);
  }
}

RememberedRegion* SalientMemory::find(const perception::SalientRegion& seen) {
  RememberedRegion* best = nullptr;
  double nearest_rad = settings_.match_rad;
  for (RememberedRegion& region : regions_) {
    if (!region.used) continue;
    const double apart_rad = std::abs(wrap_angle(region.bearing_rad - seen.bearing_rad));
    const bool both_known = std::isfinite(region.distance_m) && std::isfinite(seen.distance_m);
    if (both_known && std::abs(std::log(region.distance_m / seen.distance_m)) > kAnotherRange)
      continue;
    if (apart_rad < nearest_rad) {
      nearest_rad = apart_rad;
      best = &region;
    }
  }
  return best;
}

RememberedRegion& SalientMemory::place_for_new() {
  return *std::min_element(regions_.begin(), regions_.end(), [](const auto& a, const auto& b) {
    if (a.used != b.used) return !a.used;
    return a.activation < b.activation;
  });
}

void SalientMemory::see(const std::vector<perception::SalientRegion>& seen, double radians_per_px,
                        TimePoint stamp) {
  for (const perception::SalientRegion& look : seen) {
    RememberedRegion* region = find(look);
    if (region == nullptr) {
      RememberedRegion& place = place_for_new();
      if (place.used && place.activation >= look.salience) continue;
      place = {};
      place.used = true;
      place.id = next_id_++;
      place.first_seen = stamp;
      looked_at_s_[static_cast<std::size_t>(&place - regions_.data())] = 0.0;
      region = &place;
    }
    region->bearing_rad = look.bearing_rad;
    if (std::isfinite(look.distance_m)) region->distance_m = look.distance_m;
    region->size_rad = look.width_px * radians_per_px;
    region->salience = look.salience;
    region->activation += look.salience;
    region->last_seen = stamp;
    ++region->hits;
  }
}

void SalientMemory::attend(double gaze_rad, TimePoint now, Duration step) {
  const double decay = std::exp(-to_seconds(step) / settings_.decay_s);
  for (std::size_t i = 0; i < regions_.size(); ++i) {
    RememberedRegion& region = regions_[i];
    if (!region.used) continue;
    region.activation *= decay;
    if (to_seconds(now - region.last_seen) > settings_.expires_s) {
      region = {};
      continue;
    }
    const bool looked_at =
        std::abs(wrap_angle(region.bearing_rad - gaze_rad)) < settings_.attended_rad;
    looked_at_s_[i] = looked_at ? looked_at_s_[i] + to_seconds(step) : 0.0;
    if (looked_at_s_[i] >= settings_.attended_s) {
      region.inhibited_until = now + from_seconds(settings_.inhibition_s);
    }
  }
}

const RememberedRegion* SalientMemory::most_interesting(TimePoint now) const {
  const RememberedRegion* best = nullptr;
  for (const RememberedRegion& region : regions_) {
    if (!region.used || region.inhibited_until > now) continue;
    if (best == nullptr || region.activation > best->activation) best = &region;
  }
  return best;
}

}  // namespace striate::memory
