#include "striate/behaviours/teach.hpp"

#include <algorithm>
#include <cmath>

namespace striate::behaviours {
namespace {

// "By hand": README.md, "Where the numbers come from". Looked at on `striate trial --objects`,
// whose result is in tests/evaluation/README.md, "Things taught live".

constexpr double kAhead_rad = 0.4;   // half the view: what is farther aside is not what is meant
constexpr double kFarthest_m = 3.0;  // by hand: recognition reaches 2.5 m (`trial --objects`)
constexpr int kLeastHits = 3;        // by hand, as many looks as confirm a landmark
constexpr double kChooses_s = 6.0;   // by hand: nothing has stood out for so long
constexpr double kSettles_s = 0.8;   // by hand: longer than an image takes to arrive
constexpr double kThere_m = 0.12;    // by hand: a place this near is not driven to
constexpr double kSpeed_m_s =
    0.25;  // by hand: that of unknown floor, SpeedLimitSettings::unknown_m_s
// By hand: faster than this it does not stand still, and the image may be blurred.
constexpr double kStill_m_s = 0.01;
constexpr double kStill_rad_s = 0.02;

double bearing_of(const Point2& place, const memory::ShortTermMemory& memory) {
  const Point2 here = inverse_transform(memory.pose(), place);
  return std::atan2(here.y_m, here.x_m);
}

double away_m(const Point2& place, const memory::ShortTermMemory& memory) {
  return std::hypot(place.x_m - memory.pose().x_m, place.y_m - memory.pose().y_m);
}

}  // namespace

Teach::Teach(const Settings& settings, const RobotDescription& robot)
    : settings_(settings), robot_(robot) {}

void Teach::start(const memory::ShortTermMemory& memory) {
  phase_ = Phase::choose;
  since_ = memory.now();
  view_ = kept_ = 0;
}

Wish Teach::tick(const memory::ShortTermMemory& memory) {
  if (phase_ == Phase::choose) return choose(memory);
  if (phase_ == Phase::settle) return settle(memory);
  if (phase_ == Phase::done) return end(memory);
  const Wish wish = phase_ == Phase::drive_there ? line_->tick(memory) : turn_->tick(memory);
  if (wish.progress == Progress::running) return with_head(wish, memory);
  if (phase_ == Phase::face) {
    phase_ = Phase::settle;
    since_ = memory.now();
    if (wish.progress == Progress::failed) next_place(memory);
    return with_head(standing_wish(memory, "looks at it"), memory);
  }
  const double left_m = away_m(goal_, memory);
  if (wish.progress == Progress::succeeded && phase_ == Phase::turn_there && left_m > kThere_m) {
    phase_ = Phase::drive_there;
    line_.emplace(left_m, kSpeed_m_s);
    line_->start(memory);
    return with_head(line_->tick(memory), memory);
  }
  // As near as it gets: the thing is looked at from here.
  turn_towards(thing_, memory, Phase::face);
  return with_head(standing_wish(memory, "stands"), memory);
}

/// Of the salient regions ahead whose distance is known, the most active.
Wish Teach::choose(const memory::ShortTermMemory& memory) {
  const memory::RememberedRegion* best = nullptr;
  for (const memory::RememberedRegion& region : memory.salient().regions()) {
    const bool fits = region.used && region.hits >= kLeastHits && region.distance_m < kFarthest_m &&
                      std::abs(region.bearing_rad) < kAhead_rad;
    if (fits && (best == nullptr || region.activation > best->activation)) best = &region;
  }
  const double waited_s = to_seconds(memory.now() - since_);
  if (best != nullptr && waited_s > kSettles_s) {
    thing_ = transform(memory.pose(), Point2{best->distance_m * std::cos(best->bearing_rad),
                                             best->distance_m * std::sin(best->bearing_rad)});
    line_rad_ = std::atan2(memory.pose().y_m - thing_.y_m, memory.pose().x_m - thing_.x_m);
    turn_towards(thing_, memory, Phase::face);
  } else if (waited_s > kChooses_s) {
    return failed_wish(memory, Failure::not_found, "nothing stands out ahead within 3 m");
  }
  Wish wish = standing_wish(memory, "looks for what stands out");
  wish.tilt_rad = settings_.tilt_rad;
  return wish;
}

Wish Teach::settle(const memory::ShortTermMemory& memory) {
  const bool moves =
      std::abs(memory.forward_m_s()) > kStill_m_s || std::abs(memory.turn_rad_s()) > kStill_rad_s;
  if (moves) since_ = memory.now();
  if (to_seconds(memory.now() - since_) < kSettles_s) {
    return with_head(standing_wish(memory, "looks at it"), memory);
  }
  ++kept_;
  next_place(memory);
  return with_head(standing_wish(memory, kTakesView), memory);
}

void Teach::next_place(const memory::ShortTermMemory& memory) {
  ++view_;
  if (view_ >= settings_.views) {
    phase_ = Phase::done;
    return;
  }
  goal_ = place_of_view(view_);
  turn_towards(goal_, memory, Phase::turn_there);
}

Wish Teach::end(const memory::ShortTermMemory& memory) const {
  return kept_ > 0 ? final_wish(memory, Progress::succeeded, "looked at it from all sides")
                   : failed_wish(memory, Failure::not_found, "cannot look at it from here");
}

void Teach::turn_towards(const Point2& place, const memory::ShortTermMemory& memory, Phase phase) {
  phase_ = phase;
  // An angle of exactly 0 would mean a heading instead.
  const double by_rad = bearing_of(place, memory);
  turn_.emplace(TurnTo::Settings{.by_rad = by_rad == 0.0 ? 1e-6 : by_rad}, robot_);
  turn_->start(memory);
}

/// The first view is from where the robot is; then from nearer, and from the sides.
Point2 Teach::place_of_view(int number) const {
  // By hand: shares of `aside` and of `near`; the last two only where more than four are asked for.
  static constexpr double kAside[] = {0.0, 0.0, 1.0, -1.0, -0.5, 0.5};
  static constexpr double kAway[] = {1.0, 1.0, 1.08, 1.08, 1.3, 1.3};
  const auto k = static_cast<std::size_t>(number);
  const double angle_rad = line_rad_ + kAside[k] * settings_.aside_rad;
  const double distance_m = kAway[k] * settings_.near_m;
  return {thing_.x_m + distance_m * std::cos(angle_rad),
          thing_.y_m + distance_m * std::sin(angle_rad)};
}

/// The head looks at the thing, as far as it can.
Wish Teach::with_head(Wish wish, const memory::ShortTermMemory& memory) const {
  wish.pan_rad = std::clamp(bearing_of(thing_, memory), -robot_.max_pan_rad, robot_.max_pan_rad);
  wish.tilt_rad = settings_.tilt_rad;
  return wish;
}

}  // namespace striate::behaviours
