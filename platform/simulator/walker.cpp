#include "striate/platform/simulator/walker.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "striate/base/stopping_speed.hpp"
#include "striate/platform/simulator/obstacle_shapes.hpp"

namespace striate::simulator {
namespace {

constexpr double kR = kPersonRadius_m;  ///< of a person on the floor
/// Nearer to the robot nobody steps of his own will: a hand's breadth (ours)
constexpr double kHand_m = 0.12;
constexpr double kComfort_m = 0.32;  ///< nearer to the robot nobody likes to be (ours)
/// Likewise for other people: they give way, the robot does not (ours)
constexpr double kFriendly_m = 0.15;
/// How much a metre of way counts against comfort (ours)
constexpr double kEager = 2.5;
/// Stands within half a second from a quick walk of 1.5 m/s
constexpr double kAcceleration_m_s2 = 3.0;
constexpr double kTurning_rad_s = 5.0;  ///< turns round within 0.6 s
constexpr double kLookAhead_m = 1.0;    ///< on the way, for where to go: a second's walk (ours)
/// On his way, from where he makes for its side: kMoments at a walk, and the robot's own (ours)
constexpr double kSeesRobot_m = 2.5;
/// From its middle when passing: half width, radius and most of kComfort_m
constexpr double kBeside_m = 0.72;
constexpr double kTwoSteps_m = 1.4;  ///< length of a stride, both legs once: 0.7 m a step
constexpr double kDoorReach_m =
    0.8;  ///< nearer to a door a walker is in it: a stride's half (ours)
/// Looking ahead in time, at these moments.
constexpr std::array<double, 4> kMoments{0.3, 0.7, 1.2, 1.8};
/// Directions tried to either side of the way; beyond 95 deg he stands rather (ours)
constexpr std::array<double, 9> kOffsets_deg{0, 20, -20, 40, -40, 65, -65, 95, -95};

/// What a walker minds, against a metre of way (kEager); all ours, so that people pass each other
/// and the robot as in a real corridor.
constexpr double kMindsChange = 0.12;   ///< of velocity, for each m/s: gait is steady
constexpr double kMindsTurning = 0.1;   ///< away from the way, for each rad
constexpr double kMindsTouching = 8.0;  ///< a wall or furniture: above all else
constexpr double kTouches_m = 0.02;     ///< room to a wall that is touching
constexpr double kMindsWall = 0.5;      ///< for each metre nearer to a wall than kBesideWall_m
constexpr double kBesideWall_m = 0.12;  ///< room to a wall that is comfortable
constexpr double kMindsRobot = 4.0;     ///< nearly within kHand_m of the robot
constexpr double kMindsPerson = 3.0;    ///< nearly touching another person
constexpr double kNearly_m = 0.05;      ///< a step's error
constexpr double kMindsNearness = 2.0;  ///< for each metre nearer than comfort asks for
constexpr double kMindsRobotWithin_m =
    1.2;                                   ///< beyond, no footprint of the robot is within comfort
constexpr double kMayTouchWithin_m = 3.0;  ///< beyond, neither robot nor its braking way is near
constexpr double kHeldUp_m_s = 0.1;        ///< slower is held up
constexpr double kFaces_m_s = 0.2;         ///< slower, he does not turn to where he goes
constexpr double kLegs_m_s = 0.05;         ///< slower, the legs come together
constexpr double kThere_m = 0.12;  ///< so near to its end a way has been walked: half a radius

/// Where the robot will be if it goes on as it does now.
Pose2 predicted(const Surroundings& around, double after_s) {
  const double turn = around.robot_turn_rad_s * after_s;
  const double way = around.robot_forward_m_s * after_s;
  const double heading = around.robot.heading_rad + turn / 2;
  return {around.robot.x_m + way * std::cos(heading), around.robot.y_m + way * std::sin(heading),
          around.robot.heading_rad + turn};
}

}  // namespace

double stopping_distance_m(double forward_m_s, const RobotDescription& robot) {
  constexpr double kReaction_s = 0.3;  // 85 ms image, 100 ms cycle, 60 ms motors, and a little
  return stopping_way(forward_m_s, robot.max_acceleration_m_s2, kReaction_s);
}

void Walker::appear(Pose2 at, int look) {
  *this = Walker();
  present_ = true;
  state_.pose = at;
  state_.look = look;
  facing_rad_ = at.heading_rad;
}

void Walker::go(std::vector<Point2> way, double speed_m_s, std::vector<Point2> doors) {
  way_ = std::move(way);
  doors_ = std::move(doors);
  speed_m_s_ = speed_m_s;
  progress_m_ = 0.0;
  held_up_s_ = 0.0;
  length_m_ = 0.0;
  for (std::size_t i = 0; i + 1 < way_.size(); ++i) length_m_ += distance_m(way_[i], way_[i + 1]);
}

bool Walker::arrived() const {
  return way_.empty() || distance_m(at(), way_.back()) < kThere_m;
}

void Walker::face(Point2 place) {
  facing_rad_ = std::atan2(place.y_m - state_.pose.y_m, place.x_m - state_.pose.x_m);
}

Point2 Walker::point_on_path(double along_m) const {
  for (std::size_t i = 0; i + 1 < way_.size(); ++i) {
    const double length = distance_m(way_[i], way_[i + 1]);
    if (along_m <= length && length > 0.0) {
      const double t = along_m / length;
      return {way_[i].x_m + t * (way_[i + 1].x_m - way_[i].x_m),
              way_[i].y_m + t * (way_[i + 1].y_m - way_[i].y_m)};
    }
    along_m -= length;
  }
  return way_.back();
}

std::vector<Point2> Walker::rest_of_path() const {
  std::vector<Point2> rest;
  double along = 0.0;
  for (std::size_t i = 0; i < way_.size(); ++i) {
    if (i > 0) along += distance_m(way_[i - 1], way_[i]);
    if (along > progress_m_) rest.push_back(way_[i]);
  }
  if (!rest.empty()) rest.insert(rest.begin(), at());
  return rest;
}

void Walker::find_progress() {
  // He never goes back: the nearest place on the next metre counts.
  double best = progress_m_;
  double nearest = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= 20; ++i) {
    const double along = std::min(progress_m_ + 0.05 * i, length_m_);
    const double away = distance_m(at(), point_on_path(along));
    if (away < nearest) {
      nearest = away;
      best = along;
    }
  }
  progress_m_ = best;
}

Point2 Walker::target_on_path(const Surroundings& around) const {
  const Point2 here = point_on_path(progress_m_);
  const Point2 target = point_on_path(std::min(progress_m_ + kLookAhead_m, length_m_));
  if (distance_m(here, target) < 0.05) return target;
  // Where the robot is in the way he makes early for a place beside it, on the side with room.
  const Pose2 way{state_.pose.x_m, state_.pose.y_m,
                  std::atan2(target.y_m - here.y_m, target.x_m - here.x_m)};
  const Point2 robot = inverse_transform(way, Point2{around.robot.x_m, around.robot.y_m});
  const bool in_the_way =
      distance_to_segment_m({around.robot.x_m, around.robot.y_m}, here,
                            point_on_path(std::min(progress_m_ + kSeesRobot_m, length_m_))) <
      kBeside_m;
  if (!in_the_way || robot.x_m < -0.4) return target;
  const double ahead = robot.x_m > 1.2 ? robot.x_m - 0.7 : std::max(0.5, robot.x_m + 0.2);
  const double near_side = robot.y_m > 0.0 ? -1.0 : 1.0;
  for (const double side : {near_side, -near_side}) {
    const Point2 beside = transform(way, Point2{robot.x_m, robot.y_m + side * kBeside_m});
    if (around.map->at(beside) < kR + 0.02) continue;
    return transform(way, Point2{ahead, robot.y_m + side * kBeside_m});
  }
  return target;
}

bool Walker::at_a_door(Point2 place) const {
  return std::any_of(doors_.begin(), doors_.end(),
                     [&](const Point2& door) { return distance_m(place, door) < kDoorReach_m; });
}

void Walker::decide(const Surroundings& around) {
  wanted_x_m_s_ = 0.0;
  wanted_y_m_s_ = 0.0;
  if (arrived()) return;
  find_progress();
  const Point2 target = target_on_path(around);
  const double ahead = std::atan2(target.y_m - state_.pose.y_m, target.x_m - state_.pose.x_m);
  const double speed = std::min(speed_m_s_, 0.3 + 1.5 * distance_m(at(), way_.back()));
  Choice best{ahead, 0.0};
  double lowest = cost(best, target, around);
  for (const double share : {1.0, 0.5}) {
    for (const double offset : kOffsets_deg) {
      const Choice choice{ahead + radians(offset), share * speed};
      const double value = cost(choice, target, around) + kMindsTurning * std::abs(radians(offset));
      if (value < lowest) {
        lowest = value;
        best = choice;
      }
    }
  }
  wanted_x_m_s_ = best.speed_m_s * std::cos(best.direction_rad);
  wanted_y_m_s_ = best.speed_m_s * std::sin(best.direction_rad);
}

double Walker::cost(const Choice& choice, Point2 target, const Surroundings& around) const {
  const double vx = choice.speed_m_s * std::cos(choice.direction_rad);
  const double vy = choice.speed_m_s * std::sin(choice.direction_rad);
  const double change = std::hypot(vx - velocity_x_m_s_, vy - velocity_y_m_s_);
  double sum = kMindsChange * change;
  Point2 place = at();
  // Beyond the target the way bends: looking further would judge places he will not go to.
  const double reach = distance_m(place, target);
  for (const double moment : kMoments) {
    const double way = std::min(choice.speed_m_s * moment, reach);
    place = {state_.pose.x_m + way * std::cos(choice.direction_rad),
             state_.pose.y_m + way * std::sin(choice.direction_rad)};
    // Sooner is better: what is left of the way counts at every moment.
    sum += cost_at(place, moment, around) + kEager * distance_m(place, target) / kMoments.size();
  }
  return sum;
}

double Walker::cost_at(Point2 place, double after_s, const Surroundings& around) const {
  double sum = 0.0;
  const double urgency = 1.6 - 0.5 * after_s;
  // Who has waited long makes himself thin.
  const double comfort = std::max(0.2, 1.0 - 0.2 * held_up_s_);
  if (!at_a_door(place)) {
    const double room = around.map->at(place) - kR;
    if (room < kTouches_m && room < around.map->at(at()) - kR - 1e-6) sum += kMindsTouching;
    if (room < kBesideWall_m) sum += kMindsWall * (kBesideWall_m - room);
  }
  const Pose2 robot = predicted(around, after_s);
  if (distance_m(place, {robot.x_m, robot.y_m}) < kMindsRobotWithin_m) {
    const double room = distance_m(moved(around.footprint, robot), disc(place, kR));
    if (room < kHand_m + kNearly_m) sum += kMindsRobot * urgency;
    if (room < kComfort_m) sum += kMindsNearness * comfort * urgency * (kComfort_m - room);
  }
  for (const Passer& other : around.others) {
    const Point2 then{other.at.x_m + after_s * other.velocity_x_m_s,
                      other.at.y_m + after_s * other.velocity_y_m_s};
    const double room = distance_m(place, then) - 2 * kR;
    if (room < kNearly_m) sum += kMindsPerson * urgency;
    if (room < kFriendly_m) sum += kMindsNearness * comfort * urgency * (kFriendly_m - room);
  }
  return sum;
}

bool Walker::may_step_to(Point2 place, const Surroundings& around) const {
  const Point2 here = at();
  if (!at_a_door(place)) {
    const double room = around.map->at(place);
    if (room < kR && room < around.map->at(here)) return false;
  }
  if (distance_m(place, {around.robot.x_m, around.robot.y_m}) < kMayTouchWithin_m) {
    // A turning robot sweeps more than it covers.
    const double keep = kHand_m + 0.1 * std::min(1.0, std::abs(around.robot_turn_rad_s) / 0.5);
    for (const ConvexShape* shape : {&around.body, &around.braking}) {
      const double room = distance_m(*shape, disc(place, kR));
      if (room >= keep) continue;
      // Within the braking way the discs overlap: then the centre's distance tells what is nearer.
      if (room < distance_m(*shape, disc(here, kR))) return false;
      if (room <= 0.0 &&
          distance_m(*shape, disc(place, 0.0)) <= distance_m(*shape, disc(here, 0.0))) {
        return false;
      }
    }
  }
  return std::none_of(around.others.begin(), around.others.end(), [&](const Passer& other) {
    const double then = distance_m(place, other.at);
    return then < 2 * kR && then < distance_m(here, other.at);
  });
}

void Walker::step(double dt_s, const Surroundings& around) {
  const double dx = wanted_x_m_s_ - velocity_x_m_s_;
  const double dy = wanted_y_m_s_ - velocity_y_m_s_;
  const double change = std::hypot(dx, dy);
  const double share = change > 0.0 ? std::min(1.0, kAcceleration_m_s2 * dt_s / change) : 0.0;
  velocity_x_m_s_ += share * dx;
  velocity_y_m_s_ += share * dy;
  const Point2 next{state_.pose.x_m + velocity_x_m_s_ * dt_s,
                    state_.pose.y_m + velocity_y_m_s_ * dt_s};
  if (!may_step_to(next, around)) {
    velocity_x_m_s_ = 0.0;
    velocity_y_m_s_ = 0.0;
  }
  state_.pose.x_m += velocity_x_m_s_ * dt_s;
  state_.pose.y_m += velocity_y_m_s_ * dt_s;
  state_.speed_m_s = std::hypot(velocity_x_m_s_, velocity_y_m_s_);
  held_up_s_ = !arrived() && state_.speed_m_s < kHeldUp_m_s ? held_up_s_ + dt_s : 0.0;
  if (state_.speed_m_s > kFaces_m_s) facing_rad_ = std::atan2(velocity_y_m_s_, velocity_x_m_s_);
  turn_towards(facing_rad_, dt_s);
  swing_legs(dt_s);
}

void Walker::turn_towards(double heading_rad, double dt_s) {
  const double turn = wrap_angle(heading_rad - state_.pose.heading_rad);
  const double most = kTurning_rad_s * dt_s;
  state_.pose.heading_rad = wrap_angle(state_.pose.heading_rad + std::clamp(turn, -most, most));
}

void Walker::swing_legs(double dt_s) {
  using std::numbers::pi;
  if (state_.speed_m_s > kLegs_m_s) {
    state_.stride_rad += 2 * pi * state_.speed_m_s * dt_s / kTwoSteps_m;
  } else {  // the legs come together
    const double rest = std::round(state_.stride_rad / pi) * pi;
    state_.stride_rad += std::clamp(rest - state_.stride_rad, -4.0 * dt_s, 4.0 * dt_s);
  }
  state_.stride_rad = std::fmod(state_.stride_rad, 2 * pi);
}

}  // namespace striate::simulator
