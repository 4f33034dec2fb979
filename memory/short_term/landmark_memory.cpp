#include "striate/memory/short_term/landmark_memory.hpp"

#include <algorithm>
#include <cmath>

namespace striate::memory {
namespace {

double bearing_of(const Point2& place, const Pose2& from) {
  const Point2 here = inverse_transform(from, place);
  return std::atan2(here.y_m, here.x_m);
}

}  // namespace

void LandmarkMemory::see(const LandmarkSighting& sighting, const Pose2& at, const Pose2& now) {
  const int row = row_with(sighting);
  LandmarkInMind& entry = entry_for(sighting.landmark, sighting.name);
  if (entry.sightings == 0) entry.first_seen = sighting.stamp;
  entry.in_a_row = row;
  ++entry.sightings;
  if (entry.in_a_row >= settings_.confirming_looks) entry.confirmed = true;
  entry.score = sighting.score;
  entry.last_seen = sighting.stamp;
  entry.bearing_rad = wrap_angle(sighting.bearing_rad + at.heading_rad - now.heading_rad);
  const double sigma_m = settings_.look_sigma_share * sighting.distance_m;
  const bool betters = std::isfinite(sighting.distance_m) && sighting.distance_m > 0.0 &&
                       (!entry.place_known || sigma_m <= entry.place_sigma_m);
  if (betters) {
    entry.place = transform(at, Point2{sighting.distance_m * std::cos(sighting.bearing_rad),
                                       sighting.distance_m * std::sin(sighting.bearing_rad)});
    entry.place_sigma_m = sigma_m;
    entry.place_known = true;
  }
  if (entry.place_known) entry.bearing_rad = bearing_of(entry.place, now);
}

void LandmarkMemory::recall(std::int64_t landmark, std::string_view name, const Point2& place,
                            double sigma_m) {
  LandmarkInMind& entry = entry_for(landmark, name);
  entry.place = place;
  entry.place_sigma_m = sigma_m;
  entry.place_known = true;
}

void LandmarkMemory::move(const Pose2& before, const Pose2& after) {
  for (LandmarkInMind& entry : landmarks_) {
    if (entry.landmark == 0) continue;
    if (entry.place_known) {
      entry.bearing_rad = bearing_of(entry.place, after);
    } else {
      entry.bearing_rad = wrap_angle(entry.bearing_rad + before.heading_rad - after.heading_rad);
    }
  }
}

const LandmarkInMind* LandmarkMemory::find(std::string_view name) const {
  const LandmarkName wanted(name);
  for (const LandmarkInMind& entry : landmarks_) {
    if (entry.landmark != 0 && entry.name == wanted) return &entry;
  }
  return nullptr;
}

const LandmarkInMind* LandmarkMemory::find(std::int64_t landmark) const {
  for (const LandmarkInMind& entry : landmarks_) {
    if (landmark != 0 && entry.landmark == landmark) return &entry;
  }
  return nullptr;
}

int LandmarkMemory::row_with(const LandmarkSighting& sighting) const {
  const LandmarkInMind* entry = find(sighting.landmark);
  const bool goes_on = entry != nullptr && entry->sightings > 0 &&
                       to_seconds(sighting.stamp - entry->last_seen) <= settings_.confirming_s;
  return goes_on ? entry->in_a_row + 1 : 1;
}

bool LandmarkMemory::in_sight(std::string_view name, TimePoint now, Duration window) const {
  const LandmarkInMind* entry = find(name);
  return entry != nullptr && entry->confirmed && now - entry->last_seen <= window;
}

LandmarkInMind& LandmarkMemory::entry_for(std::int64_t landmark, std::string_view name) {
  LandmarkInMind* place = nullptr;
  for (LandmarkInMind& entry : landmarks_) {
    if (entry.landmark == landmark) return entry;
    if (entry.landmark == 0 && (place == nullptr || place->landmark != 0)) place = &entry;
    if (place == nullptr || (place->landmark != 0 && entry.last_seen < place->last_seen)) {
      place = &entry;
    }
  }
  *place = LandmarkInMind{};
  place->landmark = landmark;
  place->name = name;
  return *place;
}

}  // namespace striate::memory
