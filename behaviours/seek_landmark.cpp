#include "striate/behaviours/seek_landmark.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "striate/behaviours/control/short_format.hpp"
#include "striate/behaviours/traverse_corridor.hpp"

namespace striate::behaviours {
namespace {

// "By hand": README.md, "Where the numbers come from"; the tests are SeekLandmark.*.

constexpr Duration kNow = std::chrono::milliseconds(1000);  // by hand: so fresh is "in sight"
// By hand: a first recognition is looked at while it is fresh, half of confirming_time of the
// landmark memory, and a little longer than confirming_time in all.
constexpr double kCandidateFresh_s = 1.5;
constexpr double kCandidateLongest_s = 4.0;
// By hand: a way no longer than this is a dead end when it stays so, while the robot faces along
// the corridor within 29 degrees.
constexpr double kEndPath_m = 1.2;
constexpr double kEnd_s = 3.0;
constexpr double kTurnedTo_rad = 0.5;

}  // namespace

SeekLandmark::SeekLandmark(const Settings& settings, const RobotDescription& robot)
    : settings_(settings),
      robot_(robot),
      gaze_(settings.sweep_rad, settings.dwell_s, settings.regions, robot),
      follower_(settings.driving, robot) {}

void SeekLandmark::start(const memory::ShortTermMemory& memory) {
  const double off_rad = wrap_angle(memory.pose().heading_rad - memory.corridor().axis_rad());
  back_ = std::abs(off_rad) > 0.5 * std::numbers::pi;
  turned_ = 0;
  watching_ = false;
  candidate_at_ = memory.now();
  look_round(memory);
}

void SeekLandmark::look_round(const memory::ShortTermMemory& memory) {
  state_ = State::looking;
  gaze_.start(memory);
}

const memory::LandmarkInMind* SeekLandmark::candidate(const memory::ShortTermMemory& memory) const {
  const memory::LandmarkInMind* landmark = memory.landmarks().find(settings_.landmark);
  if (landmark == nullptr || landmark->sightings == 0) return nullptr;
  return to_seconds(memory.now() - landmark->last_seen) < kCandidateFresh_s ? landmark : nullptr;
}

Wish SeekLandmark::tick(const memory::ShortTermMemory& memory) {
  if (memory.landmarks().in_sight(settings_.landmark, memory.now(), kNow)) {
    return final_wish(memory, Progress::succeeded, short_format("sees '{}'", settings_.landmark));
  }
  const memory::LandmarkInMind* perhaps = candidate(memory);
  if (perhaps == nullptr) {
    watching_ = false;
  } else if (!watching_) {
    watching_ = true;
    candidate_at_ = memory.now();
  }
  if (perhaps != nullptr && to_seconds(memory.now() - candidate_at_) < kCandidateLongest_s) {
    Wish wish = standing_wish(memory, short_format("is that '{}'?", settings_.landmark));
    wish.pan_rad = std::clamp(perhaps->bearing_rad, -robot_.max_pan_rad, robot_.max_pan_rad);
    return wish;
  }
  return state_ == State::looking ? look(memory) : drive(memory);
}

Wish SeekLandmark::look(const memory::ShortTermMemory& memory) {
  Wish wish = standing_wish(memory, short_format("looks for '{}'", settings_.landmark));
  if (gaze_.tick(memory, wish)) return wish;
  state_ = State::driving;
  follower_.start(memory);
  driven_from_m_ = memory.distance_travelled_m();
  open_at_ = memory.now();
  return wish;
}

/// The planned way stays too short, while the robot looks along the corridor.
bool SeekLandmark::corridor_ends(const memory::ShortTermMemory& memory) {
  const Path& way = follower_.way();
  const double heading_rad =
      wrap_angle(memory.corridor().axis_rad() + (back_ ? std::numbers::pi : 0.0));
  const bool turning =
      std::abs(wrap_angle(memory.pose().heading_rad - heading_rad)) > kTurnedTo_rad;
  if (turning || (way.found && way.progress_m > kEndPath_m)) open_at_ = memory.now();
  return to_seconds(memory.now() - open_at_) > kEnd_s;
}

Wish SeekLandmark::drive(const memory::ShortTermMemory& memory) {
  Wish wish =
      follower_.tick(memory, corridor_course(memory.corridor(), back_, settings_.speed_m_s));
  if (wish.progress == Progress::failed || corridor_ends(memory)) return turn_back(memory);
  if (memory.distance_travelled_m() - driven_from_m_ >= settings_.step_m) look_round(memory);
  return wish;
}

Wish SeekLandmark::turn_back(const memory::ShortTermMemory& memory) {
  if (turned_ >= settings_.turns) {
    return failed_wish(memory, Failure::not_found,
                       short_format("does not find '{}' here", settings_.landmark));
  }
  ++turned_;
  back_ = !back_;
  look_round(memory);
  return standing_wish(memory, "the way ends here: turns back");
}

}  // namespace striate::behaviours
