#include "striate/behaviours/approach_landmark.hpp"

#include <algorithm>
#include <cmath>

#include "striate/behaviours/control/short_format.hpp"

namespace striate::behaviours {
namespace {

// "By hand": README.md, "Where the numbers come from"; the missions are seek.yaml and
// find_and_return.yaml, the tests ApproachLandmark.* in tests/unit/behaviours.

// By hand: beyond the wanted distance, where the straight way begins, and how fast it is driven: at
// most, speed per metre that is left, and at least.
constexpr double kClosing_m = 0.9;
constexpr double kClosing_m_s = 0.18;
constexpr double kClosingGain_1_s = 0.6;
constexpr double kLeast_m_s = 0.06;
constexpr double kArrived_m = 0.05;  // by hand: less than a look's error of the place
// By hand: no nearer, by kNearer_m, for so long is as near as things allow, which is an arrival
// within kNearEnough_m of the distance.
constexpr double kNearer_m = 0.02;
constexpr double kBlocked_s = 2.5;
constexpr double kNearEnough_m = 1.0;
constexpr double kClosingClear_m = 0.10;  // by hand: what carries the landmark is near by intent
// By hand: facing it means within 6 degrees, turned to briskly.
constexpr double kFacing_rad = 0.10;
constexpr double kTurn_rad_s = 0.5;
constexpr double kTurnGain_1_s = 1.2;
constexpr double kLookFor_s = 6.0;  // by hand: twice confirming_time of the landmark memory
constexpr Duration kFresh = std::chrono::milliseconds(1500);  // by hand: half of confirming_time

}  // namespace

ApproachLandmark::ApproachLandmark(const Settings& settings, const RobotDescription& robot)
    : settings_(settings),
      robot_(robot),
      journey_(settings.driving, robot),
      steering_(robot, settings.driving.wanted_clearance_m) {
  straight_.found = true;
  straight_.count = 2;
}

void ApproachLandmark::start(const memory::ShortTermMemory& memory) {
  journey_.start(memory);
  enter(State::driving, memory);
}

void ApproachLandmark::enter(State state, const memory::ShortTermMemory& memory) {
  state_ = state;
  entered_ = memory.now();
  nearest_m_ = perception::kNothing_m;
  nearest_at_ = memory.now();
}

Wish ApproachLandmark::watch(const memory::ShortTermMemory& memory,
                             const memory::LandmarkInMind& landmark, ShortText why) const {
  Wish wish = standing_wish(memory, why);
  wish.pan_rad = std::clamp(landmark.bearing_rad, -robot_.max_pan_rad, robot_.max_pan_rad);
  return wish;
}

Wish ApproachLandmark::tick(const memory::ShortTermMemory& memory) {
  const memory::LandmarkInMind* landmark = memory.landmarks().find(settings_.landmark);
  if (landmark == nullptr || !landmark->place_known) {
    return failed_wish(memory, Failure::not_known,
                       short_format("does not know where '{}' is", settings_.landmark));
  }
  if (state_ == State::facing) return face(memory, *landmark);
  if (state_ == State::closing) return close_in(memory, *landmark);
  const double left_m = distance_to_m(memory, landmark->place) - settings_.stop_at_m;
  if (left_m <= kClosing_m) {
    enter(State::closing, memory);
    return close_in(memory, *landmark);
  }
  Wish wish = journey_.tick(memory, landmark->place, settings_.speed_m_s);
  if (wish.progress == Progress::running && wish.why.view() == "drives on") {
    wish.why = short_format("drives up to '{}', {:.1f} m", settings_.landmark, left_m);
  }
  return wish;
}

Wish ApproachLandmark::close_in(const memory::ShortTermMemory& memory,
                                const memory::LandmarkInMind& landmark) {
  const double left_m = distance_to_m(memory, landmark.place) - settings_.stop_at_m;
  if (left_m < nearest_m_ - kNearer_m) {
    nearest_m_ = left_m;
    nearest_at_ = memory.now();
  }
  const bool blocked = to_seconds(memory.now() - nearest_at_) > kBlocked_s;
  if (left_m <= kArrived_m || (blocked && left_m <= kNearEnough_m)) {
    enter(State::facing, memory);
    return face(memory, landmark);
  }
  if (blocked) {
    return failed_wish(memory, Failure::way_blocked,
                       short_format("cannot come nearer to '{}'", settings_.landmark));
  }
  field_.update(memory.map());
  straight_.points[0] = {memory.pose().x_m, memory.pose().y_m};
  straight_.points[1] = landmark.place;
  straight_.least_margin_m = 0.0;
  const double speed_m_s = std::clamp(kClosingGain_1_s * left_m, kLeast_m_s, kClosing_m_s);
  const Drive drive =
      steering_.follow(straight_, field_, memory.pose(), {speed_m_s, kClosingClear_m, true});
  Wish wish = watch(memory, landmark, short_format("closes in on '{}'", settings_.landmark));
  if (drive.possible) {
    wish.forward_m_s = drive.forward_m_s;
    wish.turn_rad_s = drive.turn_rad_s;
  }
  return wish;
}

Wish ApproachLandmark::face(const memory::ShortTermMemory& memory,
                            const memory::LandmarkInMind& landmark) {
  const double off_rad = landmark.bearing_rad;
  const bool facing = std::abs(off_rad) < kFacing_rad;
  const bool seen = memory.landmarks().in_sight(settings_.landmark, memory.now(), kFresh);
  if (facing && seen) {
    return final_wish(memory, Progress::succeeded,
                      short_format("stands before '{}'", settings_.landmark));
  }
  if (to_seconds(memory.now() - entered_) > kLookFor_s) {
    return failed_wish(memory, facing ? Failure::not_found : Failure::cannot_turn,
                       facing ? short_format("does not recognise '{}' here", settings_.landmark)
                              : short_format("cannot turn to '{}' here", settings_.landmark));
  }
  Wish wish = watch(memory, landmark, short_format("faces '{}'", settings_.landmark));
  if (!facing) wish.turn_rad_s = std::clamp(kTurnGain_1_s * off_rad, -kTurn_rad_s, kTurn_rad_s);
  return wish;
}

}  // namespace striate::behaviours
