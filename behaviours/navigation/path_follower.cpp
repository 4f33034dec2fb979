#include "striate/behaviours/navigation/path_follower.hpp"

#include <algorithm>
#include <cmath>

#include "striate/behaviours/control/short_format.hpp"
#include "striate/behaviours/navigation/behind.hpp"
#include "striate/behaviours/view_angles.hpp"

namespace striate::behaviours {
namespace {

// "By hand": README.md, "Where the numbers come from".

// Tilts. The eyes are 1.20 m high and half the image is 16.5 degrees: looking down, the floor is
// in view from 1.0 m before the axle (0.6 rad is the turret's end), glancing down from 1.4 m.
constexpr double kLookDown_rad = -0.58;
constexpr double kGlanceDown_rad = -0.42;
// By hand: the head is down for the first moment, and again for so long where much is unknown.
constexpr Duration kFirstLookDown = std::chrono::milliseconds(700);
constexpr double kLookDownFor_s = 0.6;
// By hand: what is low shows by the second power of how near it is, so the floor is looked at from
// near once before it is driven over. So often the view from 1.4 m to the resting one's 2.1 m has
// seen all of it.
constexpr double kGlanceEvery_m = 0.65;
constexpr Duration kGlanceFor = std::chrono::milliseconds(350);  // 0.1 s there, two images
constexpr double kMuchUnknown = 0.3;    // by hand: share of the next two metres
constexpr double kHeadTurn_rad = 0.6;   // by hand: standing, the eyes may leave the lane
constexpr double kDrives_m_s = 0.1;     // by hand: faster than this the narrow limit holds
constexpr double kGazeAhead_m = 1.8;    // by hand: the point of the way that is looked at
constexpr double kNearestGaze_m = 0.3;  // by hand: nearer, its bearing would leap
// By hand, looked at on `striate trial` in corridor_a to c: people pass within some seconds.
constexpr double kMoverPatience_s = 5.0;
constexpr double kImpossible_s = 0.6;     // by hand, six cycles: a flicker of the map is no trouble
constexpr double kStart_m = 0.5;          // by hand: the first way, over floor never in view
constexpr double kForgivenAfter_m = 1.0;  // by hand: headway that makes old troubles forgotten
constexpr double kUnstuck_m = 0.25;       // by hand: less headway is to and fro on the spot
// By hand: from the third trouble on 0.06 m of margin become 0.024 m, half a patch of the map.
constexpr int kTightAfter = 2;
constexpr double kTightShare = 0.4;
// By hand: steering may come nearer than the planned way, which is laid in whole cells.
constexpr double kSteeringShare = 0.6;
constexpr double kLeastSpeed_m_s = 0.03;     // by hand: a slower wish gets nowhere; it waits
constexpr double kClearlySlower_m_s = 0.05;  // by hand: than the cruise: worth a reason
}  // namespace

PathFollower::PathFollower(const DrivingSettings& settings, const RobotDescription& robot)
    : settings_(settings),
      robot_(robot),
      look_down_rad_(same_floor_tilt(robot, kLookDown_rad)),
      glance_down_rad_(same_floor_tilt(robot, kGlanceDown_rad)),
      pan_driving_rad_(pan_while_driving(robot)),
      steering_(robot, settings.wanted_clearance_m) {}

void PathFollower::start(const memory::ShortTermMemory& memory) {
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
  look_down_until_ = memory.now() + kFirstLookDown;
  enter(State::driving, memory);
}

void PathFollower::enter(State state, const memory::ShortTermMemory& memory) {
  state_ = state;
  back_m_ = settings_.back_m;
  entered_ = memory.now();
  free_to_move_at_ = memory.now();
  entered_pose_ = memory.pose();
}

double PathFollower::since_entered_s(const memory::ShortTermMemory& memory) const {
  return to_seconds(memory.now() - entered_);
}

void PathFollower::measure_headway(const memory::ShortTermMemory& memory, const Course& course) {
  const Pose2 frame{last_pose_.x_m, last_pose_.y_m, course.direction_rad};
  headway_m_ += inverse_transform(frame, Point2{memory.pose().x_m, memory.pose().y_m}).x_m;
  last_pose_ = memory.pose();
  if (headway_m_ > best_headway_m_ + kUnstuck_m) {
    best_headway_m_ = headway_m_;
    best_headway_at_ = memory.now();
  }
  if (headway_m_ > trouble_headway_m_ + kForgivenAfter_m) troubles_ = 0;
}

// The first tries keep the full margin; after that a tighter fit is better than giving up.
double PathFollower::least_margin_m() const {
  return settings_.least_margin_m * (troubles_ < kTightAfter ? 1.0 : kTightShare);
}

bool PathFollower::path_is_open() const {
  return planner_.way().found;
}

Wish PathFollower::tick(const memory::ShortTermMemory& memory, const Course& course) {
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
    return failed_wish(memory, Failure::way_blocked,
                       short_format("no way through after {} tries in one place", troubles_));
  }
  if ((state_ == State::driving || state_ == State::waiting) && feels_something(memory)) {
    leave_what_was_felt(memory);
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

Wish PathFollower::drive(const memory::ShortTermMemory& memory, const Course& course) {
  Wish wish = standing_wish(memory, "drives on");
  if (to_seconds(memory.now() - best_headway_at_) > settings_.stuck_after_s) {
    best_headway_at_ = memory.now();
    enter(State::looking, memory);
    return look(memory);
  }
  if (!path_is_open()) {
    enter(State::waiting, memory);
    return wait(memory, course);
  }
  SpeedLimit speed_limit =
      speed_limit_for(settings_.speed_limit, robot_, memory, field_, planner_.way());
  if (!speed_limit.waits_for_mover) mover_since_ = memory.now();
  const bool dim = memory.light_level() < settings_.speed_limit.dark_below ||
                   memory.noise_level() > settings_.speed_limit.noisy_above;
  double speed = std::min(speed_limit.speed_m_s,
                          course.cruise_m_s * (dim ? settings_.speed_limit.dim_share : 1.0));
  if (speed_limit.waits_for_mover && to_seconds(memory.now() - mover_since_) > kMoverPatience_s) {
    speed = settings_.speed_limit.narrow_m_s;  // it moves without coming or going: creep past
  }
  wish.forward_m_s = speed;
  aim_head(memory, speed_limit, wish);
  wish.forward_m_s = 0.0;
  if (speed < kLeastSpeed_m_s) {
    impossible_since_ = memory.now();
    free_to_move_at_ = memory.now();
    wish.why = short_format("waits: {}", speed_limit.reason);
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
  aim_head(memory, speed_limit, wish);
  if (speed < course.cruise_m_s - kClearlySlower_m_s) {
    wish.why = short_format(
        "slow: {}", dim && speed_limit.speed_m_s > speed ? "it is dark" : speed_limit.reason);
  }
  return wish;
}

Drive PathFollower::steer(const memory::ShortTermMemory& memory, const Course& course,
                          double speed_m_s) const {
  return steering_.follow(planner_.way(), field_, memory.pose(),
                          {speed_m_s, kSteeringShare * least_margin_m(), troubles_ >= kTightAfter,
                           course.direction_rad, course.left_wall_m, course.right_wall_m});
}

void PathFollower::aim_head(const memory::ShortTermMemory& memory, const SpeedLimit& speed_limit,
                            Wish& wish) {
  const Point2 ahead =
      inverse_transform(memory.pose(), Steering::point_at(planner_.way(), kGazeAhead_m));
  const double most_rad = wish.forward_m_s > kDrives_m_s ? pan_driving_rad_ : kHeadTurn_rad;
  wish.pan_rad =
      std::clamp(std::atan2(ahead.y_m, std::max(kNearestGaze_m, ahead.x_m)), -most_rad, most_rad);
  if (std::isfinite(speed_limit.mover_m))
    wish.pan_rad = std::clamp(speed_limit.mover_rad, -most_rad, most_rad);
  if (speed_limit.unknown_near_share > kMuchUnknown) {
    look_down_until_ = memory.now() + from_seconds(kLookDownFor_s);
  }
  const bool glances = glances_down(memory, speed_limit, wish.forward_m_s);
  const bool starts = headway_m_ < kStart_m;  // the floor before the wheels was never in view
  wish.tilt_rad = memory.now() < look_down_until_ ? (starts ? look_down_rad_ : glance_down_rad_)
                  : glances                       ? glance_down_rad_
                                                  : robot_.resting_tilt_rad;
}

/// Now and then, while it drives and nobody moves ahead, at the floor that comes next.
bool PathFollower::glances_down(const memory::ShortTermMemory& memory,
                                const SpeedLimit& speed_limit, double speed_m_s) {
  if (std::isfinite(speed_limit.mover_m) || speed_m_s < kDrives_m_s) return false;
  const Point2 gone = inverse_transform(glanced_at_, Point2{memory.pose().x_m, memory.pose().y_m});
  if (std::hypot(gone.x_m, gone.y_m) > kGlanceEvery_m) {
    glanced_at_ = memory.pose();
    glance_until_ = memory.now() + kGlanceFor;
  }
  return memory.now() < glance_until_;
}

}  // namespace striate::behaviours
