#include "striate/memory/localisation/slam_estimate.hpp"

#include <algorithm>
#include <cmath>

namespace striate::memory {
namespace {

/// The place of the start is estimated like that of a landmark.
constexpr int kStart = 0;
/// By hand: contradictions of known landmarks after which the run did not start at home.
constexpr int kContradictions = 3;
/// By hand: known landmarks nearer to each other than this say little about the heading.
constexpr double kApart_m = 1.0;
/// By hand: rejected looks in a row after which a landmark is taken for moved, or put wrongly at
/// first: at least, and at most for one that was seen often.
constexpr int kLeastRejected = 3;
constexpr int kMostRejected = 8;
/// Of a look without a range, by hand: the middle errs by 0.05 m, at 2.5 m by this angle.
constexpr double kMiddleOff_rad = 0.02;
/// By hand, much more than any error: of a frame found by two landmarks, before they are taken as
/// measurements of it.
constexpr double kFrameSigma_m = 5.0;
constexpr double kFrameSigma_rad = 0.5;

/// Without the image's focal length and baseline nothing says how far off the range may be.
bool has_range(const LandmarkSighting& sighting) {
  return std::isfinite(sighting.distance_m) && sighting.distance_m > 0.0 &&
         sighting.disparity_metre_px > 0.0;
}

double distance_m(const MapPosition& a, const MapPosition& b) {
  return std::hypot(a.x_m - b.x_m, a.y_m - b.y_m);
}

double bearing_rad(const MapPosition& from, const MapPosition& to) {
  return std::atan2(to.y_m - from.y_m, to.x_m - from.x_m);
}

}  // namespace

void SlamEstimate::start(const Pose2& odometry) {
  odometry_ = odometry;
  filter_.start(odometry);
  filter_.add_known({odometry.x_m, odometry.y_m, 0.0, 0.0, 0.0});  // kStart: never removed
  start_heading_rad_ = odometry.heading_rad;
  located_ = !map_is_known_;
}

void SlamEstimate::know(std::int64_t landmark, const std::optional<MapPosition>& place) {
  MappedLandmark one;
  one.landmark = landmark;
  one.known = place;
  if (place) {
    // The filter is not told how the errors of known places hang together, and each has the error
    // of its middle in common with all its looks: without this it becomes surer than it is.
    one.known->var_x_m2 += settings_.middle_error_m * settings_.middle_error_m;
    one.known->var_y_m2 += settings_.middle_error_m * settings_.middle_error_m;
  }
  landmarks_.push_back(one);
  if (!place) return;
  map_is_known_ = true;
  located_ = false;
}

void SlamEstimate::move(const Pose2& odometry) {
  const Pose2 step = inverse_transform(odometry_, odometry);
  odometry_ = odometry;
  way_m_ += std::hypot(step.x_m, step.y_m);
  turned_rad_ += std::abs(step.heading_rad);
  filter_.predict(step);
}

SightingVerdict SlamEstimate::see(const LandmarkSighting& sighting, const Pose2& at) {
  MappedLandmark* one = entry_for(sighting.landmark);
  if (one == nullptr) return SightingVerdict::no_room;
  const bool looked_before = one->taken > 0 || one->rejected > 0;
  if (looked_before && way_m_ - one->looked_at_m < settings_.new_look_after_m &&
      turned_rad_ - one->looked_at_rad < settings_.new_look_after_rad) {
    return SightingVerdict::too_alike;
  }
  one->looked_at_m = way_m_;
  one->looked_at_rad = turned_rad_;
  const SightingVerdict look = take(*one, sighting, inverse_transform(odometry_, at));
  if (look == SightingVerdict::taken || look == SightingVerdict::placed) {
    one->seen_at_m = way_m_;
    one->news = true;
    if (!located_) try_to_locate(*one);
  }
  return look;
}

/// @param from where the image was taken, in the robot's frame now
SightingVerdict SlamEstimate::take(MappedLandmark& one, const LandmarkSighting& sighting,
                                   const Pose2& from) {
  std::optional<EkfSlam::Seen> seen;
  if (has_range(sighting)) seen = seen_from(sighting, from);
  const bool comes_in = one.number < 0;
  if (comes_in && !(one.known && located_))
    return seen ? put(one, *seen) : SightingVerdict::no_range;
  if (comes_in) {
    if (!make_room()) return SightingVerdict::no_room;
    one.number = filter_.add_known(*one.known);
  }
  const EkfSlam::SeenBearing bearing{from, sighting.bearing_rad,
                                     std::hypot(settings_.bearing_error_rad, kMiddleOff_rad)};
  const double distance2 =
      seen ? filter_.distance2(one.number, *seen) : filter_.distance2(one.number, bearing);
  if (distance2 > settings_.gate) {
    if (comes_in) drop(one);
    return reject(one, seen);
  }
  if (seen) {
    filter_.update(one.number, *seen);
  } else {
    filter_.update(one.number, bearing);
  }
  one.rejected = 0;
  ++one.taken;
  return SightingVerdict::taken;
}

/// A few odd looks change nothing; where they go on, the landmark is not where it was thought.
SightingVerdict SlamEstimate::reject(MappedLandmark& one,
                                     const std::optional<EkfSlam::Seen>& seen) {
  ++one.rejected;
  const int trusted = one.known ? kMostRejected : one.taken;
  if (!seen || one.rejected < std::clamp(trusted, kLeastRejected, kMostRejected)) {
    return SightingVerdict::rejected;
  }
  one.known.reset();
  if (one.number >= 0) drop(one);
  return put(one, *seen);
}

SightingVerdict SlamEstimate::put(MappedLandmark& one, const EkfSlam::Seen& seen) {
  if (!make_room()) return SightingVerdict::no_room;
  one.number = filter_.add_seen(seen);
  one.taken = 1;
  one.rejected = 0;
  return SightingVerdict::placed;
}

/// Bearing is precise; the range comes from a disparity, whose error makes sigma_Z = Z^2 sigma_d /
/// (f B). What is taken for the middle of a landmark differs from side to side.
EkfSlam::Seen SlamEstimate::seen_from(const LandmarkSighting& sighting, const Pose2& from) const {
  const double range_m = sighting.distance_m;
  const double along_m =
      range_m * range_m * settings_.disparity_error_px / sighting.disparity_metre_px;
  const double across_m = range_m * settings_.bearing_error_rad;
  const double middle_m2 = settings_.middle_error_m * settings_.middle_error_m;
  const double along_m2 = along_m * along_m + middle_m2;
  const double across_m2 = across_m * across_m + middle_m2;
  const Point2 here = transform(from, Point2{range_m * std::cos(sighting.bearing_rad),
                                             range_m * std::sin(sighting.bearing_rad)});
  const double direction_rad = from.heading_rad + sighting.bearing_rad;
  const double c = std::cos(direction_rad);
  const double s = std::sin(direction_rad);
  return {here.x_m, here.y_m, c * c * along_m2 + s * s * across_m2, c * s * (along_m2 - across_m2),
          s * s * along_m2 + c * c * across_m2};
}

/// Where the filter is full, the landmark not seen for longest goes back to be one that is known
/// from elsewhere.
bool SlamEstimate::make_room() {
  if (filter_.size() < EkfSlam::kLandmarks) return true;
  MappedLandmark* oldest = nullptr;
  for (MappedLandmark& one : landmarks_) {
    if (one.number < 0) continue;
    if (oldest == nullptr || one.seen_at_m < oldest->seen_at_m) oldest = &one;
  }
  if (oldest == nullptr) return false;
  if (located_ && oldest->taken >= kSure) oldest->known = filter_.place(oldest->number);
  drop(*oldest);
  return true;
}

void SlamEstimate::drop(MappedLandmark& one) {
  const int last = filter_.size() - 1;
  filter_.remove(one.number);
  for (MappedLandmark& other : landmarks_) {
    if (other.number == last) other.number = one.number;
  }
  one.number = -1;
}

MappedLandmark* SlamEstimate::entry_for(std::int64_t landmark) {
  for (MappedLandmark& one : landmarks_) {
    if (one.landmark == landmark) return &one;
  }
  return nullptr;
}

void SlamEstimate::try_to_locate(const MappedLandmark& newest) {
  if (!newest.known || newest.number < 0) return;
  if (may_have_started_at_home()) {
    if (filter_.distance2_to(newest.number, from_home(*newest.known)) <= settings_.gate) {
      locate({}, settings_.start_error_m, settings_.start_error_rad);
      return;
    }
    ++contradictions_;
  }
  for (const MappedLandmark& other : landmarks_) {
    if (&other == &newest || other.number < 0 || !other.known) continue;
    if (newest.taken < kSure || other.taken < kSure) continue;
    if (const std::optional<Pose2> frame = frame_by(newest, other)) {
      locate(*frame, kFrameSigma_m, kFrameSigma_rad);
      return;
    }
  }
}

bool SlamEstimate::may_have_started_at_home() const {
  return !located_ && settings_.starts_at_home && contradictions_ < kContradictions;
}

/// Where a known landmark lies in the run's own frame if the run started where the map does.
MapPosition SlamEstimate::from_home(const MapPosition& known) const {
  MapPosition expected = known;
  const double sigma2_m2 = settings_.start_error_m * settings_.start_error_m;
  const double turn2 = settings_.start_error_rad * settings_.start_error_rad;
  expected.var_x_m2 += sigma2_m2 + turn2 * expected.y_m * expected.y_m;
  expected.cov_xy_m2 -= turn2 * expected.x_m * expected.y_m;
  expected.var_y_m2 += sigma2_m2 + turn2 * expected.x_m * expected.x_m;
  return expected;
}

/// The frame that puts both where they are known to be; nothing where they do not lie to each other
/// as they should, or too near.
std::optional<Pose2> SlamEstimate::frame_by(const MappedLandmark& a,
                                            const MappedLandmark& b) const {
  const MapPosition seen_a = filter_.place(a.number);
  const MapPosition seen_b = filter_.place(b.number);
  const double known_m = distance_m(*a.known, *b.known);
  if (known_m < kApart_m) return std::nullopt;
  double variance_m2 = 0.0;
  for (const MapPosition& one : {seen_a, seen_b, *a.known, *b.known}) {
    variance_m2 += std::max(one.var_x_m2, one.var_y_m2);
  }
  const double differs_m = distance_m(seen_a, seen_b) - known_m;
  if (differs_m * differs_m > settings_.gate * variance_m2) return std::nullopt;
  const double turn_rad = wrap_angle(bearing_rad(*a.known, *b.known) - bearing_rad(seen_a, seen_b));
  const Pose2 turned{0.0, 0.0, turn_rad};
  const Point2 middle =
      transform(turned, Point2{(seen_a.x_m + seen_b.x_m) / 2.0, (seen_a.y_m + seen_b.y_m) / 2.0});
  return Pose2{(a.known->x_m + b.known->x_m) / 2.0 - middle.x_m,
               (a.known->y_m + b.known->y_m) / 2.0 - middle.y_m, turn_rad};
}

void SlamEstimate::locate(const Pose2& frame, double sigma_m, double sigma_rad) {
  filter_.change_frame(frame, {sigma_m * sigma_m, 0.0, 0.0, 0.0, sigma_m * sigma_m, 0.0, 0.0, 0.0,
                               sigma_rad * sigma_rad});
  located_ = true;
  start_heading_rad_ = wrap_angle(start_heading_rad_ + frame.heading_rad);
  for (MappedLandmark& one : landmarks_) {
    if (one.number < 0 || !one.known) continue;
    if (filter_.distance2_to(one.number, *one.known) > settings_.gate) continue;
    filter_.fuse(one.number, *one.known);
  }
}

Pose2 SlamEstimate::from_odometry() const {
  return transform(filter_.pose(), inverse_transform(odometry_, Pose2{}));
}

Pose2 SlamEstimate::start() const {
  const MapPosition at = filter_.place(kStart);
  return {at.x_m, at.y_m, start_heading_rad_};
}

std::optional<MapPosition> SlamEstimate::place(const MappedLandmark& landmark) const {
  if (landmark.number >= 0) return filter_.place(landmark.number);
  if (located_) return landmark.known;
  return std::nullopt;
}

std::optional<MapPosition> SlamEstimate::place(std::int64_t landmark) const {
  for (const MappedLandmark& one : landmarks_) {
    if (one.landmark == landmark) return place(one);
  }
  return std::nullopt;
}

std::optional<MapPosition> SlamEstimate::place_from_robot(const MappedLandmark& landmark) const {
  if (landmark.number >= 0) return filter_.place_from_robot(landmark.number);
  if (located_ && landmark.known) return filter_.from_robot(*landmark.known);
  if (may_have_started_at_home() && landmark.known) {
    return filter_.from_robot(from_home(*landmark.known));
  }
  return std::nullopt;
}

}  // namespace striate::memory
