#include "striate/behaviours/navigation/steering.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace striate::behaviours {
namespace {

// "By hand": README.md, "Where the numbers come from".

// By hand. Pure pursuit cuts corners the more the farther it looks, and swings the nearer: 1 m at
// 0.45 m/s, and the least where the way has less margin than kTightWay_m.
constexpr double kLookaheadLeast_m = 0.55;
constexpr double kLookaheadPerSpeed_s = 1.0;
constexpr double kTightWay_m = 0.15;
constexpr double kNearestTarget_m = 0.1;  // by hand: nearer, the curvature would leap
// By hand: a target farther aside is faced first. How briskly, with at most
// three quarters of the turn rate that the body allows.
constexpr double kTurnInPlace_rad = 0.9;
constexpr double kMostTurn_rad_s = 0.9;
constexpr double kSteeringGain_1_s = 1.2;
// On the spot, by hand: more calmly; and only a turn round may also go the other way.
constexpr double kMostTurnInPlace_rad_s = 0.7;
constexpr double kTurnRound_rad = 2.0;
// By hand: slower the farther aside the target, but never below a share; and curvature counts as at
// a speed at least, or a robot that stands would never turn.
constexpr double kEasing = 1.3;  // factor of the target's angle
constexpr double kEasedLeast = 0.3;
constexpr double kCurvedAt_m_s = 0.15;
constexpr double kRollOut_s = 1.4;    // to stop from 0.65 m/s at 0.5 m/s2 takes 1.3 s
constexpr double kRollStep_s = 0.1;   // a cycle; 0.065 m at 0.65 m/s
constexpr double kEdgeLook_s = 1.0;   // by hand: where on the arc the seen floor is looked at
constexpr double kSqueezed_m = 0.10;  // by hand: less room is no room where an edge is, too
// By hand. `striate trial`, 60 m, when it came together with denser stereo and kHeadDriving_rad:
// corridor_b seed 2 had no emergency stop instead of 4, corridor_a seed 9 and corridor_c seed 5 no
// touch.
constexpr double kRoomBefore_m = 0.15;
constexpr double kWallRoom_m = 0.12;    // the place of a remembered wall errs by about this
constexpr double kAlongWall_m = 0.003;  // a step's least approach: at 0.65 m/s 2.6 degrees
// By hand: turn rates tried beside the wanted one, and shares of the speed; finer near the wanted.
constexpr std::array<double, 11> kTurnOffsets{0.0,  0.08, -0.08, 0.18, -0.18, 0.3,
                                              -0.3, 0.5,  -0.5,  0.8,  -0.8};
constexpr std::array<double, 3> kSpeedShares{1.0, 0.6, 0.3};
// By hand: what an arc costs beside its offset in rad/s, for no room left, an edge of seen floor at
// the flank, and all speed given up.
constexpr double kCrowdedArc = 0.8;
constexpr double kEdgingPrice = 0.7;
constexpr double kSlownessPrice = 0.5;

}  // namespace

// What stands near is measured a hand's breadth too far: the camera looks over the feet and sees
// the trunk. Beside the robot the room was measured from farther off, before it came alongside.
RobotDescription Steering::with_room_before(RobotDescription robot) {
  robot.front_m += kRoomBefore_m;
  return robot;
}

Point2 Steering::point_at(const Path& way, double length_m) {
  double left_m = length_m;
  for (std::size_t i = 1; i < way.count; ++i) {
    const Point2& a = way.points[i - 1];
    const Point2& b = way.points[i];
    const double step_m = std::hypot(b.x_m - a.x_m, b.y_m - a.y_m);
    if (step_m >= left_m) {
      const double t = step_m > 0.0 ? left_m / step_m : 0.0;
      return {a.x_m + t * (b.x_m - a.x_m), a.y_m + t * (b.y_m - a.y_m)};
    }
    left_m -= step_m;
  }
  return way.count > 0 ? way.points[way.count - 1] : Point2{};
}

// The least clearance on the arc; negative where it comes too near, unless it leads away from
// what is already too near.
double Steering::roll_out(const FloorField& field, const Pose2& robot, const Candidate& candidate,
                          double least_clearance_m) const {
  const double here_m = footprint_.clearance_m(field, robot);
  double least_m = FloorField::kFar_m;
  double last_m = here_m;
  for (double t = kRollStep_s; t <= kRollOut_s + 1e-9; t += kRollStep_s) {
    const Pose2 pose = along_arc(robot, candidate.forward_m_s, candidate.turn_rad_s, t);
    const double clear_m = footprint_.clearance_m(field, pose);
    if (clear_m < least_clearance_m && clear_m < last_m - 1e-9) return -1.0;
    if (clear_m < least_clearance_m && here_m >= least_clearance_m) return -1.0;
    last_m = clear_m;
    least_m = std::min(least_m, clear_m);
  }
  return least_m;
}

// Room beside both walls must not fall below kWallRoom_m; what is nearer already may be left.
bool Steering::keeps_off_walls(const Pose2& robot, const Candidate& candidate,
                               const Limits& limits) const {
  const Pose2 along{robot.x_m, robot.y_m, limits.direction_rad};
  const auto room_m = [&](const Pose2& pose) {
    return std::min(
        limits.left_wall_m - footprint_.farthest_left_m(inverse_transform(along, pose)),
        limits.right_wall_m - footprint_.farthest_right_m(inverse_transform(along, pose)));
  };
  double last_m = room_m(robot);
  for (double t = kRollStep_s; t <= kRollOut_s + 1e-9; t += kRollStep_s) {
    const double now_m = room_m(along_arc(robot, candidate.forward_m_s, candidate.turn_rad_s, t));
    if (now_m < kWallRoom_m && now_m < last_m - kAlongWall_m) return false;
    last_m = now_m;
  }
  return true;
}

Drive Steering::turn_in_place(double angle_rad, const FloorField& field, const Pose2& robot,
                              double least_clearance_m) const {
  const double rate =
      std::clamp(kSteeringGain_1_s * angle_rad, -kMostTurnInPlace_rad_s, kMostTurnInPlace_rad_s);
  for (const double sign : {1.0, -1.0}) {
    const double clear_m = roll_out(field, robot, {0.0, sign * rate}, least_clearance_m);
    if (clear_m >= 0.0) return {true, 0.0, sign * rate, clear_m};
    if (std::abs(angle_rad) < kTurnRound_rad) break;  // only a turn round may go the other way
  }
  return {};
}

Drive Steering::follow(const Path& way, const FloorField& field, const Pose2& robot,
                       const Limits& limits) const {
  const double speed_m_s = limits.speed_m_s;
  const double least_clearance_m = limits.least_clearance_m;
  double lookahead_m = kLookaheadLeast_m + kLookaheadPerSpeed_s * speed_m_s;
  if (way.least_margin_m < kTightWay_m) lookahead_m = kLookaheadLeast_m;
  const Point2 target = inverse_transform(robot, point_at(way, lookahead_m));
  const double distance_m = std::max(kNearestTarget_m, std::hypot(target.x_m, target.y_m));
  const double angle_rad = std::atan2(target.y_m, target.x_m);
  if (std::abs(angle_rad) > kTurnInPlace_rad) {
    return turn_in_place(angle_rad, field, robot, least_clearance_m);
  }
  const double curvature = 2.0 * std::sin(angle_rad) / distance_m;
  const double eased_m_s = speed_m_s * std::max(kEasedLeast, std::cos(kEasing * angle_rad));
  Drive best;
  double least = 1e9;
  for (const double share : kSpeedShares) {
    const double forward = share * eased_m_s;
    const double wanted =
        std::clamp(curvature * std::max(forward, kCurvedAt_m_s), -kMostTurn_rad_s, kMostTurn_rad_s);
    for (const double offset : kTurnOffsets) {
      const Candidate candidate{forward, wanted + offset};
      const double clear_m = roll_out(field, robot, candidate, least_clearance_m);
      if (clear_m < 0.0) continue;
      if (!limits.daring && !keeps_off_walls(robot, candidate, limits)) continue;
      const double crowding = std::max(0.0, 1.0 - clear_m / wanted_clearance_m_);
      const Pose2 end = along_arc(robot, forward, candidate.turn_rad_s, kEdgeLook_s);
      const double edge_m = footprint_.seen_clearance_m(field, end);
      if (!limits.daring && clear_m < kSqueezed_m && edge_m <= 0.0) continue;
      const double edging = std::max(0.0, 1.0 - edge_m / wanted_clearance_m_);
      const double score = std::abs(offset) + kCrowdedArc * crowding * crowding +
                           kEdgingPrice * edging + kSlownessPrice * (1.0 - share);
      if (score < least) {
        least = score;
        best = {true, candidate.forward_m_s, candidate.turn_rad_s, clear_m};
      }
    }
  }
  return best.possible ? best : turn_in_place(angle_rad, field, robot, least_clearance_m);
}

}  // namespace striate::behaviours
