#include <algorithm>
#include <array>
#include <cmath>

#include "striate/base/stopping_speed.hpp"
#include "striate/platform/simulator/obstacle_shapes.hpp"
#include "striate/platform/simulator/walker.hpp"

namespace striate::simulator {
namespace {

/// Nearer to the robot nobody steps of his own will: a hand's breadth (ours)
constexpr double kHand_m = 0.12;
constexpr double kComfort_m = 0.32;  ///< nearer to the robot nobody likes to be (ours)
/// Likewise for other people: they give way, the robot does not (ours)
constexpr double kFriendly_m = 0.15;
/// How much a metre of way counts against comfort (ours)
constexpr double kEager = 2.5;
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

/// Where the robot will be if it goes on as it does now.
Pose2 predicted(const Surroundings& around, double after_s) {
  const double turn = around.robot_turn_rad_s * after_s;
  const double way = around.robot_forward_m_s * after_s;
  const double heading = around.robot.heading_rad + turn / 2;
  return {around.robot.x_m + way * std::cos(heading), around.robot.y_m + way * std::sin(heading),
          around.robot.heading_rad + turn};
}

}  // namespace

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
    const double room = around.map->at(place) - kPersonRadius_m;
    if (room < kTouches_m && room < around.map->at(at()) - kPersonRadius_m - 1e-6)
      sum += kMindsTouching;
    if (room < kBesideWall_m) sum += kMindsWall * (kBesideWall_m - room);
  }
  const Pose2 robot = predicted(around, after_s);
  if (distance_m(place, {robot.x_m, robot.y_m}) < kMindsRobotWithin_m) {
    const double room = distance_m(moved(around.footprint, robot), disc(place, kPersonRadius_m));
    if (room < kHand_m + kNearly_m) sum += kMindsRobot * urgency;
    if (room < kComfort_m) sum += kMindsNearness * comfort * urgency * (kComfort_m - room);
  }
  for (const Passer& other : around.others) {
    const Point2 then{other.at.x_m + after_s * other.velocity_x_m_s,
                      other.at.y_m + after_s * other.velocity_y_m_s};
    const double room = distance_m(place, then) - 2 * kPersonRadius_m;
    if (room < kNearly_m) sum += kMindsPerson * urgency;
    if (room < kFriendly_m) sum += kMindsNearness * comfort * urgency * (kFriendly_m - room);
  }
  return sum;
}

bool Walker::may_step_to(Point2 place, const Surroundings& around) const {
  const Point2 here = at();
  if (!at_a_door(place)) {
    const double room = around.map->at(place);
    if (room < kPersonRadius_m && room < around.map->at(here)) return false;
  }
  if (distance_m(place, {around.robot.x_m, around.robot.y_m}) < kMayTouchWithin_m) {
    // A turning robot sweeps more than it covers.
    const double keep = kHand_m + 0.1 * std::min(1.0, std::abs(around.robot_turn_rad_s) / 0.5);
    for (const ConvexShape* shape : {&around.body, &around.braking}) {
      const double room = distance_m(*shape, disc(place, kPersonRadius_m));
      if (room >= keep) continue;
      // Within the braking way the discs overlap: then the centre's distance tells what is nearer.
      if (room < distance_m(*shape, disc(here, kPersonRadius_m))) return false;
      if (room <= 0.0 &&
          distance_m(*shape, disc(place, 0.0)) <= distance_m(*shape, disc(here, 0.0))) {
        return false;
      }
    }
  }
  return std::none_of(around.others.begin(), around.others.end(), [&](const Passer& other) {
    const double then = distance_m(place, other.at);
    return then < 2 * kPersonRadius_m && then < distance_m(here, other.at);
  });
}

}  // namespace striate::simulator
