#include "striate/behaviours/explore.hpp"

#include <algorithm>
#include <cmath>

#include "striate/behaviours/control/short_format.hpp"

namespace striate::behaviours {
namespace {

// "By hand": README.md, "Where the numbers come from"; the mission is config/tasks/explore.yaml,
// the tests are Explore.* in tests/unit/behaviours.

constexpr double kThinkEvery_s = 0.5;  // by hand: five cycles, in which it drives 0.2 m
constexpr double kMissing_s = 1.5;     // by hand: no goal for so long (three searches): look round
// By hand: no nearer to the goal, by kWorthGoing_m, for so long: leave it; sooner where the robot
// is there and it is still unknown: then there is nothing to be seen.
constexpr double kNoNearer_s = 12.0;
constexpr double kWorthGoing_m = 0.2;
constexpr double kAtGoal_m = 0.9;
constexpr double kAtGoal_s = 3.0;
constexpr double kSameGoal_m = 1.0;     // by hand: goals nearer to each other are one that wanders
constexpr double kPassedApart_m = 1.5;  // by hand: edges that were passed are kept so far apart
// By hand: more than the 0.20 m2 that a frontier needs, for the way back is long.
constexpr double kWorthReturning_m2 = 0.35;
constexpr double kAtPassed_m = 0.9;  // by hand, as near as kAtGoal_m
// By hand: floor that a round over all that was given up must bring; less is next to nothing.
constexpr double kWorthARound_m2 = 2.0;
constexpr double kReturnLongest_s = 120.0;  // by hand: 48 m at 0.40 m/s
constexpr double kDwell_s = 0.5;            // by hand: several images in each direction
constexpr int kTurns = 3;                   // a whole turn, by kTurn_rad
constexpr double kTurn_rad = 2.1;           // three of them are a whole turn
// By hand: half of the turn rate that the body allows; a third of a turn takes 3.5 s and its end.
constexpr double kLookRound_rad_s = 0.6;
constexpr double kTurnLongest_s = 8.0;
constexpr double kTurned_rad = 0.06;  // by hand, 3 degrees: a tenth of a second of turning

}  // namespace

Explore::Explore(const Settings& settings, const RobotDescription& robot)
    : settings_(settings),
      finder_(robot),
      gaze_(settings.sweep_rad, kDwell_s, 0, robot),
      journey_(settings.driving, robot) {}

void Explore::start(const memory::ShortTermMemory& memory) {
  finder_.forget();
  goal_ = {};
  passed_count_ = 0;
  turns_ = 0;
  failures_ = 0;
  area_at_round_m2_ = -kWorthARound_m2;
  thought_ = {};
  enter(State::looking, memory);
}

void Explore::enter(State state, const memory::ShortTermMemory& memory) {
  state_ = state;
  entered_ = memory.now();
  found_at_ = memory.now();
  nearest_at_ = memory.now();
  nearest_m_ = perception::kNothing_m;
  if (state == State::looking) gaze_.start(memory);
  if (state == State::driving || state == State::returning) journey_.start(memory);
  turn_left_rad_ = kTurn_rad;
  last_heading_rad_ = memory.pose().heading_rad;
}

Wish Explore::tick(const memory::ShortTermMemory& memory) {
  if (to_seconds(memory.now() - thought_) >= kThinkEvery_s) think(memory);
  switch (state_) {
    case State::looking:
      return look(memory);
    case State::turning:
      return turn(memory);
    case State::returning:
      return go_back(memory);
    case State::driving:
      break;
  }
  return drive(memory);
}

void Explore::think(const memory::ShortTermMemory& memory) {
  thought_ = memory.now();
  field_.update(memory.map());
  finder_.note(field_, memory.pose());
  if (state_ == State::driving) choose(memory);
}

void Explore::choose(const memory::ShortTermMemory& memory) {
  const Frontier before = goal_;
  goal_ = finder_.find(field_, memory.pose());
  if (!goal_.found) return;
  found_at_ = memory.now();
  turns_ = 0;
  finder_.prefer(goal_.place);
  if (before.found && apart_m(before.place, goal_.place) < kSameGoal_m) return;
  if (before.found) remember_passed(before.place);
  nearest_m_ = perception::kNothing_m;
  nearest_at_ = memory.now();
}

void Explore::remember_passed(Point2 place) {
  const auto end = passed_.begin() + static_cast<std::ptrdiff_t>(passed_count_);
  const bool known = std::any_of(passed_.begin(), end, [place](Point2 other) {
    return apart_m(place, other) < kPassedApart_m;
  });
  if (!known && passed_count_ < kPassed) passed_[passed_count_++] = place;
}

bool Explore::pick_passed(const memory::ShortTermMemory& memory) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < passed_count_; ++i) {
    const bool still = finder_.unknown_round_m2(field_, passed_[i]) > kWorthReturning_m2 &&
                       !finder_.avoided(passed_[i]);
    if (still) passed_[kept++] = passed_[i];
  }
  passed_count_ = kept;
  if (passed_count_ == 0) return false;
  back_to_ = *std::min_element(
      passed_.begin(), passed_.begin() + static_cast<std::ptrdiff_t>(passed_count_),
      [&](Point2 a, Point2 b) { return distance_to_m(memory, a) < distance_to_m(memory, b); });
  return true;
}

Wish Explore::leave(const memory::ShortTermMemory& memory, Point2 place) {
  finder_.avoid(place);
  goal_ = {};
  if (distance_to_m(memory, place) > kAtGoal_m && ++failures_ >= settings_.failures) {
    return failed_wish(memory, Failure::way_blocked,
                       short_format("cannot get on: {} goals in a row not reached", failures_));
  }
  enter(State::looking, memory);
  return standing_wish(memory, "leaves this edge of the map");
}

Wish Explore::drive(const memory::ShortTermMemory& memory) {
  if (!goal_.found) {
    if (to_seconds(memory.now() - found_at_) > kMissing_s) {
      enter(State::looking, memory);
      return look(memory);
    }
    return standing_wish(memory, "looks for the edge of the map");
  }
  const double left_m = distance_to_m(memory, goal_.place);
  if (left_m < nearest_m_ - kWorthGoing_m) {
    nearest_m_ = left_m;
    nearest_at_ = memory.now();
    failures_ = 0;
  }
  const double since_s = to_seconds(memory.now() - nearest_at_);
  if (since_s > kNoNearer_s || (left_m < kAtGoal_m && since_s > kAtGoal_s)) {
    return leave(memory, goal_.place);
  }
  Wish wish = journey_.steer(memory, goal_.next, settings_.speed_m_s);
  if (wish.progress == Progress::failed) return leave(memory, goal_.place);
  if (wish.why.view() == "drives on") {
    wish.why = short_format("explores, {:.0f} m2 known", finder_.known().area_m2());
  }
  return wish;
}

Wish Explore::look(const memory::ShortTermMemory& memory) {
  Wish wish = standing_wish(memory, "looks round for the edge of the map");
  if (gaze_.tick(memory, wish)) return wish;
  think(memory);
  goal_ = finder_.find(field_, memory.pose());
  if (goal_.found) {
    enter(State::driving, memory);
  } else if (turns_ < kTurns) {
    ++turns_;
    enter(State::turning, memory);
  } else if (pick_passed(memory)) {
    enter(State::returning, memory);
  } else if (tries_again()) {
    enter(State::looking, memory);
  } else {
    return final_wish(memory, Progress::succeeded,
                      short_format("explored {:.0f} m2", finder_.known().area_m2()));
  }
  return wish;
}

/// What shut a way may have been seen wrongly and faded since: places that were given up are tried
/// again, until a round of them brings next to nothing.
bool Explore::tries_again() {
  const double area_m2 = finder_.known().area_m2();
  if (area_m2 < area_at_round_m2_ + kWorthARound_m2) return false;
  area_at_round_m2_ = area_m2;
  finder_.forget_avoided();
  turns_ = 0;
  return true;
}

Wish Explore::turn(const memory::ShortTermMemory& memory) {
  turn_left_rad_ -= wrap_angle(memory.pose().heading_rad - last_heading_rad_);
  last_heading_rad_ = memory.pose().heading_rad;
  Wish wish = standing_wish(memory, "turns to see what is behind");
  const bool over =
      turn_left_rad_ < kTurned_rad || to_seconds(memory.now() - entered_) > kTurnLongest_s;
  if (over) {
    enter(State::looking, memory);
    return wish;
  }
  wish.turn_rad_s = std::min(kLookRound_rad_s, turn_left_rad_);
  return wish;
}

Wish Explore::go_back(const memory::ShortTermMemory& memory) {
  if (distance_to_m(memory, back_to_) < kAtPassed_m) {
    turns_ = 0;
    enter(State::looking, memory);
    return look(memory);
  }
  Wish wish = journey_.tick(memory, back_to_, settings_.speed_m_s);
  const bool longest = to_seconds(memory.now() - entered_) > kReturnLongest_s;
  if (wish.progress == Progress::failed || longest) return leave(memory, back_to_);
  if (wish.why.view() == "drives on") wish.why = "goes back to an edge that it passed";
  return wish;
}

}  // namespace striate::behaviours
