#include <cmath>

#include "striate/behaviours/control/short_format.hpp"
#include "striate/behaviours/navigation/behind.hpp"
#include "striate/behaviours/navigation/path_follower.hpp"

/// How the path follower gets out of trouble: it waits, looks round for a gap, backs out.
namespace striate::behaviours {
namespace {

// "By hand": README.md, "Where the numbers come from".

// By hand: five parts of 0.8 s (left high, left low, right high, right low, ahead); the turret
// turns 1.6 rad in each.
constexpr double kLookSweep_s = 4.0;
// With half the view (0.375 rad) everything within 73 degrees to either side is seen.
constexpr double kSweep_rad = 0.9;
// By hand, looked at on `striate trial` in corridor_a to c: what stands still does not pass.
constexpr double kStillPatience_s = 1.0;
constexpr double kWaitLane_m = 1.2;   // half the 2.4 m of the shipped corridors: all of it
constexpr double kStaysOpen_s = 0.5;  // by hand, five cycles: a gap that flickers is none
constexpr double kGrace_s = 0.5;      // by hand: after backing or waiting no arc is needed sooner
// By hand: so long it wishes to move and stands; TraverseCorridor.BacksOutSoonWhereItIsHeld...
constexpr double kHeld_s = 3.0;
constexpr double kStands_m_s = 0.015;          // by hand: slower than this it stands
constexpr double kStandsTurning_rad_s = 0.03;  // by hand: the same for turning
// Backing, by hand: slowly, since no eye looks there; the outline is tried 0.15 m on (1.5 s at
// 0.1 m/s), more than it rolls on in a latency of 0.35 s and a stop (0.06 m).
constexpr double kBackSpeed_m_s = 0.12;
constexpr double kBackLook_m_s = -0.1;
constexpr double kBackLook_s = 1.5;
constexpr double kBackClear_m = 0.03;
constexpr double kBackLongest_s = 5.0;  // by hand: 0.35 m take 2.9 s at this speed
// By hand: from here the front gets round 0.4 m, its half width and that of a thing as wide, in two
// arcs of 60 degrees.
constexpr double kBackFromFelt_m = 0.70;
constexpr double kBackFromFeltLongest_s = 8.0;  // by hand: they take 5.8 s
// By hand: three cycles and a half.
constexpr Duration kJustFelt = std::chrono::milliseconds(350);

}  // namespace

// The limiter counts a remembered thing nearer than steering does, and has the last word: what
// steering finds clear it may refuse for ever.
bool PathFollower::is_held(const memory::ShortTermMemory& memory) {
  const bool moves = std::abs(memory.forward_m_s()) > kStands_m_s ||
                     std::abs(memory.turn_rad_s()) > kStandsTurning_rad_s;
  if (moves) free_to_move_at_ = memory.now();
  return to_seconds(memory.now() - free_to_move_at_) > kHeld_s;
}

/// Stopped by what no eye has seen: looking for a gap shows nothing, room to turn is needed.
bool PathFollower::feels_something(const memory::ShortTermMemory& memory) const {
  return memory.felt_within(kJustFelt) && std::abs(memory.forward_m_s()) < kStands_m_s &&
         free_behind_m(memory, robot_) > kRoomBehind_m;
}

void PathFollower::leave_what_was_felt(const memory::ShortTermMemory& memory) {
  note_trouble(memory);
  enter(State::backing, memory);
  back_m_ = kBackFromFelt_m;
}

void PathFollower::note_trouble(const memory::ShortTermMemory& memory) {
  ++troubles_;
  trouble_headway_m_ = headway_m_;
  planner_.forget_choice();
  best_headway_at_ = memory.now();
  best_headway_m_ = headway_m_;
}

Wish PathFollower::wait(const memory::ShortTermMemory& memory, const Course& course) {
  const double since_s = since_entered_s(memory);
  // A way that opens for a moment is noise: it has to stay open.
  if (path_is_open() && since_s > kStaysOpen_s) {
    impossible_since_ = memory.now() + from_seconds(kGrace_s);
    const Drive drive = steer(memory, course, settings_.speed_limit.narrow_m_s);
    if (drive.possible) enter(State::driving, memory);
  }
  // Only what moves is worth waiting for.
  const bool something_moves = std::isfinite(nearest_mover(memory, kWaitLane_m).distance_m);
  if (since_s > (something_moves ? settings_.patience_s : kStillPatience_s)) {
    enter(State::looking, memory);
  }
  Wish wish = standing_wish(memory, short_format("waits: the way is blocked, {:.0f} s", since_s));
  wish.tilt_rad = glance_down_rad_;
  return wish;
}

Wish PathFollower::look(const memory::ShortTermMemory& memory) {
  const double since_s = since_entered_s(memory);
  Wish wish = standing_wish(memory, "looks round for a gap");
  const double phase = since_s / kLookSweep_s;
  wish.pan_rad = phase < 0.4 ? kSweep_rad : (phase < 0.8 ? -kSweep_rad : 0.0);
  const bool far = phase < 0.2 || (phase > 0.4 && phase < 0.6);
  wish.tilt_rad = far ? robot_.resting_tilt_rad : look_down_rad_;
  if (phase < 1.0) return wish;
  note_trouble(memory);
  enter(troubles_ % 2 == 0 || !path_is_open() ? State::backing : State::driving, memory);
  return wish;
}

/// What was felt may touch a flank already: then going back must only come no nearer to it.
bool PathFollower::may_back_to(const Pose2& behind, const memory::ShortTermMemory& memory) const {
  const double there_m = steering_.footprint().clearance_m(field_, behind);
  if (there_m > kBackClear_m) return true;
  return memory.felt_within(memory::FeltThings::kBelieved) &&
         there_m >= steering_.footprint().clearance_m(field_, memory.pose());
}

Wish PathFollower::back(const memory::ShortTermMemory& memory) {
  Wish wish = standing_wish(memory, "backs out");
  const Point2 moved =
      inverse_transform(entered_pose_, Point2{memory.pose().x_m, memory.pose().y_m});
  const Pose2 behind = along_arc(memory.pose(), kBackLook_m_s, 0.0, kBackLook_s);
  const bool clear = may_back_to(behind, memory) && free_behind_m(memory, robot_) > kRoomBehind_m;
  const double longest_s = back_m_ > settings_.back_m ? kBackFromFeltLongest_s : kBackLongest_s;
  if (-moved.x_m >= back_m_ || !clear || since_entered_s(memory) > longest_s) {
    impossible_since_ = memory.now() + from_seconds(kGrace_s);
    enter(path_is_open() ? State::driving : State::waiting, memory);
    return wish;
  }
  wish.forward_m_s = -kBackSpeed_m_s;
  return wish;
}

}  // namespace striate::behaviours
