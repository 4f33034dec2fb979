#include "behaviours/way_follower.hpp"

#include <algorithm>
#include <cmath>

#include "behaviours/behind.hpp"
#include "behaviours/short_format.hpp"
#include "behaviours/view_angles.hpp"

namespace striate {
namespace {

constexpr double kLookDown_rad = -0.58;  // of the Pioneer's head, as the next
constexpr double kGlanceDown_rad = -0.42;
constexpr double kLookSweep_s = 4.0;
constexpr double kSweep_rad = 0.9;
constexpr double kHeadTurn_rad = 0.6;
constexpr double kMoverPatience_s = 5.0;
constexpr double kStillPatience_s = 1.0;
constexpr double kWaitLane_m = 1.2;
constexpr double kImpossible_s = 0.6;
constexpr double kStart_m = 0.5;
constexpr double kForgivenAfter_m = 1.0;  // headway that makes old troubles forgotten
constexpr double kUnstuck_m = 0.25;
constexpr int kTightAfter = 2;  // troubles
constexpr double kTightShare = 0.4;
constexpr double kHeld_s = 3.0;  // so long it wishes to move and does not
constexpr double kStands_m_s = 0.015;
constexpr double kStands_rad_s = 0.03;

}  // namespace

WayFollower::WayFollower(const DrivingSettings& settings, const RobotDescription& robot)
    : settings_(settings),
      robot_(robot),
      look_down_rad_(same_floor_tilt(robot, kLookDown_rad)),
      glance_down_rad_(same_floor_tilt(robot, kGlanceDown_rad)),
      pan_driving_rad_(pan_while_driving(robot)),
      steering_(robot, settings.wanted_clearance_m) {}

void WayFollower::start(const ShortTermMemory& memory) {
  planner_.forget_choice();
  troubles_ = 0;
  headway_m_ = 0.0;
  best_headway_m_ = 0.0;
  trouble_headway_m_ = 0.0;
  best_headway_at_ = memory.now();
  last_pose_ = memory.pose();
  impossible_since_ = memory.now();
  mover_since_ = memory.now();
  free_to_move_at_ = memory.now();
  // The camera has not seen the floor before the wheels: look there before the first metre.
  look_down_until_ = memory.now() + std::chrono::milliseconds(700);
  enter(State::driving, memory);
}

void WayFollower::enter(State state, const ShortTermMemory& memory) {
  state_ = state;
  entered_ = memory.now();
  free_to_move_at_ = memory.now();
  entered_pose_ = memory.pose();
}

double WayFollower::since_entered_s(const ShortTermMemory& memory) const {
  return to_seconds(memory.now() - entered_);
}

void WayFollower::measure_headway(const ShortTermMemory& memory, const Course& course) {
  const Pose2 frame{last_pose_.x_m, last_pose_.y_m, course.direction_rad};
  headway_m_ += to_inner(frame, Point2{memory.pose().x_m, memory.pose().y_m}).x_m;
  last_pose_ = memory.pose();
  if (headway_m_ > best_headway_m_ + kUnstuck_m) {
    best_headway_m_ = headway_m_;
    best_headway_at_ = memory.now();
  }
  if (headway_m_ > trouble_headway_m_ + kForgivenAfter_m) troubles_ = 0;
}

// The first tries keep the full margin; after that a tighter fit is better than giving up.
double WayFollower::least_margin_m() const {
  return settings_.least_margin_m * (troubles_ < kTightAfter ? 1.0 : kTightShare);
}

bool WayFollower::way_is_open() const {
  return planner_.way().found;
}

Wish WayFollower::tick(const ShortTermMemory& memory, const Course& course) {
  measure_headway(memory, course);
  field_.update(memory.map());
  PlanRequest request;
  request.direction_rad = course.direction_rad;
  request.wanted_left_m = course.wanted_left_m;
  request.half_width_m = robot_.half_width_m;
  request.least_margin_m = least_margin_m();
  request.left_wall_m = course.left_wall_m;
  request.right_wall_m = course.right_wall_m;
  request.middle_left_m = course.middle_left_m;
  request.half_corridor_m = course.half_corridor_m;
  // In trouble the corridor may be another than remembered: what was closed is only dear.
  request.corridor_sure = course.corridor_sure && troubles_ == 0;
  planner_.plan(field_, memory.pose(), request);
  if (troubles_ >= settings_.tries) {
    return final_wish(memory, Progress::failed,
                      short_format("no way through after {} tries in one place", troubles_));
  }
  switch (state_) {
    case State::waiting:
      return wait(memory, course);
    case State::looking:
      return look(memory);
    case State::backing:
      return back(memory);
    case State::driving:
      break;
  }
  return drive(memory, course);
}

Wish WayFollower::drive(const ShortTermMemory& memory, const Course& course) {
  Wish wish = standing_wish(memory, "drives on");
  if (to_seconds(memory.now() - best_headway_at_) > settings_.stuck_after_s) {
    best_headway_at_ = memory.now();
    enter(State::looking, memory);
    return look(memory);
  }
  if (!way_is_open()) {
    enter(State::waiting, memory);
    return wait(memory, course);
  }
  Pace pace = pace_for(settings_.pace, robot_, memory, field_, planner_.way());
  if (!pace.waits_for_mover) mover_since_ = memory.now();
  const bool dim = memory.light_level() < settings_.pace.dark_below ||
                   memory.noise_level() > settings_.pace.noisy_above;
  double speed =
      std::min(pace.speed_m_s, course.cruise_m_s * (dim ? settings_.pace.dim_share : 1.0));
  if (pace.waits_for_mover && to_seconds(memory.now() - mover_since_) > kMoverPatience_s) {
    speed = settings_.pace.narrow_m_s;  // it moves without coming or going: creep past
  }
  wish.forward_m_s = speed;
  aim_head(memory, pace, wish);
  wish.forward_m_s = 0.0;
  if (speed < 0.03) {
    impossible_since_ = memory.now();
    free_to_move_at_ = memory.now();
    wish.why = short_format("waits: {}", pace.reason);
    return wish;
  }
  const Drive drive = steer(memory, course, speed);
  if (!drive.possible) {
    free_to_move_at_ = memory.now();
    wish.why = "no arc keeps clear";
    if (to_seconds(memory.now() - impossible_since_) > kImpossible_s) {
      enter(State::waiting, memory);
    }
    return wish;
  }
  impossible_since_ = memory.now();
  if (is_held(memory)) {
    enter(free_behind_m(memory, robot_) > kRoomBehind_m ? State::backing : State::looking, memory);
    if (state_ == State::backing) note_trouble(memory);
    return state_ == State::backing ? back(memory) : look(memory);
  }
  wish.forward_m_s = drive.forward_m_s;
  wish.turn_rad_s = drive.turn_rad_s;
  aim_head(memory, pace, wish);
  if (speed < course.cruise_m_s - 0.05) {
    wish.why = short_format("slow: {}", dim && pace.speed_m_s > speed ? "it is dark" : pace.reason);
  }
  return wish;
}

// The limiter counts a remembered thing nearer than steering does, and has the last word: what
// steering finds clear it may refuse for ever.
bool WayFollower::is_held(const ShortTermMemory& memory) {
  const bool moves =
      std::abs(memory.forward_m_s()) > kStands_m_s || std::abs(memory.turn_rad_s()) > kStands_rad_s;
  if (moves) free_to_move_at_ = memory.now();
  return to_seconds(memory.now() - free_to_move_at_) > kHeld_s;
}

void WayFollower::note_trouble(const ShortTermMemory& memory) {
  ++troubles_;
  trouble_headway_m_ = headway_m_;
  planner_.forget_choice();
  best_headway_at_ = memory.now();
  best_headway_m_ = headway_m_;
}

Drive WayFollower::steer(const ShortTermMemory& memory, const Course& course,
                         double speed_m_s) const {
  return steering_.follow(planner_.way(), field_, memory.pose(),
                          {speed_m_s, 0.6 * least_margin_m(), troubles_ >= kTightAfter,
                           course.direction_rad, course.left_wall_m, course.right_wall_m});
}

void WayFollower::aim_head(const ShortTermMemory& memory, const Pace& pace, Wish& wish) {
  const Point2 ahead = to_inner(memory.pose(), Steering::point_at(planner_.way(), 1.8));
  const double most_rad = wish.forward_m_s > 0.1 ? pan_driving_rad_ : kHeadTurn_rad;
  wish.pan_rad = std::clamp(std::atan2(ahead.y_m, std::max(0.3, ahead.x_m)), -most_rad, most_rad);
  if (std::isfinite(pace.mover_m)) wish.pan_rad = std::clamp(pace.mover_rad, -most_rad, most_rad);
  if (pace.unknown_near_share > 0.3) look_down_until_ = memory.now() + from_seconds(0.6);
  const bool starts = headway_m_ < kStart_m;  // the floor before the wheels was never in view
  wish.tilt_rad = memory.now() >= look_down_until_ ? robot_.resting_tilt_rad
                  : starts                         ? look_down_rad_
                                                   : glance_down_rad_;
}

Wish WayFollower::wait(const ShortTermMemory& memory, const Course& course) {
  const double since_s = since_entered_s(memory);
  // A way that opens for a moment is noise: it has to stay open.
  if (way_is_open() && since_s > 0.5) {
    impossible_since_ = memory.now() + from_seconds(0.5);
    const Drive drive = steer(memory, course, settings_.pace.narrow_m_s);
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

Wish WayFollower::look(const ShortTermMemory& memory) {
  const double since_s = since_entered_s(memory);
  Wish wish = standing_wish(memory, "looks round for a gap");
  const double phase = since_s / kLookSweep_s;
  wish.pan_rad = phase < 0.4 ? kSweep_rad : (phase < 0.8 ? -kSweep_rad : 0.0);
  const bool far = phase < 0.2 || (phase > 0.4 && phase < 0.6);
  wish.tilt_rad = far ? robot_.resting_tilt_rad : look_down_rad_;
  if (phase < 1.0) return wish;
  note_trouble(memory);
  enter(troubles_ % 2 == 0 || !way_is_open() ? State::backing : State::driving, memory);
  return wish;
}

Wish WayFollower::back(const ShortTermMemory& memory) {
  Wish wish = standing_wish(memory, "backs out");
  const Point2 moved = to_inner(entered_pose_, Point2{memory.pose().x_m, memory.pose().y_m});
  const Pose2 behind = along_arc(memory.pose(), -0.1, 0.0, 1.5);
  const bool clear = steering_.footprint().clearance_m(field_, behind) > 0.03 &&
                     free_behind_m(memory, robot_) > kRoomBehind_m;
  if (-moved.x_m >= settings_.back_m || !clear || since_entered_s(memory) > 5.0) {
    impossible_since_ = memory.now() + from_seconds(0.5);
    enter(way_is_open() ? State::driving : State::waiting, memory);
    return wish;
  }
  wish.forward_m_s = -0.12;
  return wish;
}

}  // namespace striate
