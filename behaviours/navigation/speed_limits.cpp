#include "striate/behaviours/navigation/speed_limits.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "striate/base/stopping_speed.hpp"
#include "striate/behaviours/navigation/steering.hpp"

namespace striate::behaviours {
namespace {

// "By hand": README.md, "Where the numbers come from".

constexpr double kStep_m = 0.1;       // that of the planned way, PathPlanner::kStep_m
constexpr double kFineStep_m = 0.05;  // a patch of the map, LocalGrid::kCell_m
constexpr double kHole_m = 0.15;      // a column or two without a match
constexpr double kAside_m = 0.15;     // by hand: two of three samples across must be free
// From 0.75 m/s the robot stops within 1.0 m (0.4 m/s2 after 0.35 s): farther than that is enough.
constexpr double kLook_m = 3.0;
constexpr double kNear_m = 2.0;         // by hand: where unknown floor makes the head look down
constexpr double kUnknownRun_m = 0.35;  // so much unknown in a row ends what is known free
// By hand: the stop is planned with a fifth of the deceleration in reserve, and ends before.
constexpr double kBrakeShare = 0.8;
constexpr double kStopBefore_m = 0.10;
constexpr double kUnderBumper_m = 0.1;  // by hand: before the front end, below the view: passed
// By hand: margins count so far along the way (1.2 s at 0.75 m/s); at this margin the robot is at
// its slowest, a little above what a gap must leave (DrivingSettings::least_margin_m).
constexpr double kMarginsTo_m = 0.9;
constexpr double kNarrowest_m = 0.08;
constexpr double kEdgeTrust_m = 0.10;  // by hand: an edge may be a wall, but is less likely one
// Movers. Just above the level to which memory/evidence.cpp calms quickly what stays (kSettled).
constexpr float kMoves = 0.36F;  // 0 still .. 1 moving
constexpr double kMoversTo_m =
    2.6;  // each way: all within SpeedLimitSettings::moving_slow_m and more
constexpr double kBeforeAxle_m = 0.1;  // by hand: what is beside or behind is not waited for
constexpr int kMoverPatches = 3;       // a person is many patches wide, a flicker one or two
constexpr double kLane_m = 0.7;        // by hand: the robot's half width and half a metre
constexpr double kMoverShare = 0.6;    // by hand: of the full speed when something moves ahead
// `striate trial`, corridor_a to c and hard_dark_people: stood before slow movers for ever without.
constexpr double kCreep_m_s = 0.10;

bool seen_free(const FloorField& field, Point2 middle, double ux, double uy) {
  int free = 0;
  for (const double aside_m : {-kAside_m, 0.0, kAside_m}) {
    const Point2 place{middle.x_m - aside_m * uy, middle.y_m + aside_m * ux};
    free += field.state(place) == memory::CellState::free;
  }
  return free >= 2;
}

void measure_known(const FloorField& field, const Path& way, double front_m,
                   SpeedLimit& speed_limit) {
  double unknown_run_m = 0.0;
  double near_unknown = 0.0;
  bool open = true;
  Point2 last = Steering::point_at(way, 0.0);
  for (double s = kStep_m; s <= kLook_m; s += kStep_m) {
    const Point2 place = Steering::point_at(way, s);
    const double length_m = std::hypot(place.x_m - last.x_m, place.y_m - last.y_m);
    if (length_m < 1e-6) break;
    const bool known = s <= front_m || seen_free(field, place, (place.x_m - last.x_m) / length_m,
                                                 (place.y_m - last.y_m) / length_m);
    last = place;
    unknown_run_m = known ? 0.0 : unknown_run_m + kStep_m;
    if (!known && s <= kNear_m) near_unknown += kStep_m;
    if (unknown_run_m > kUnknownRun_m) open = false;
    if (open) speed_limit.known_free_m = s - unknown_run_m;
  }
  speed_limit.unknown_near_share = near_unknown / kNear_m;
}

/// How far straight on from the front end the floor is seen free, all across the robot: where it
/// goes if the turn does not come in time.
double free_straight_on_m(const FloorField& field, const Pose2& pose,
                          const RobotDescription& robot) {
  double least_m = kLook_m;
  for (const double aside_m : {-robot.half_width_m, 0.0, robot.half_width_m}) {
    double unknown_run_m = 0.0;
    for (double s = kFineStep_m; s < least_m; s += kFineStep_m) {
      const Point2 place = transform(pose, Point2{robot.front_m + s, aside_m});
      unknown_run_m =
          field.state(place) == memory::CellState::free ? 0.0 : unknown_run_m + kFineStep_m;
      if (unknown_run_m > kHole_m) least_m = s - unknown_run_m;
    }
  }
  return std::max(0.0, least_m);
}

void cap(SpeedLimit& speed_limit, double speed_m_s, const char* reason) {
  if (speed_m_s >= speed_limit.speed_m_s) return;
  speed_limit.speed_m_s = speed_m_s;
  speed_limit.reason = reason;
}

struct Margins {
  double things_m = FloorField::kFar_m;
  double edges_m = FloorField::kFar_m;
};

Margins margins_of_next(const FloorField& field, const Path& way, double half_width_m) {
  Margins least;
  for (double s = 0.0; s <= kMarginsTo_m; s += kStep_m) {
    const Point2 place = Steering::point_at(way, s);
    // The edge of what is known may be a wall, but is less likely one.
    const double edge_m = field.seen_clearance_m(place) + kEdgeTrust_m;
    least.things_m = std::min(least.things_m, field.clearance_m(place) - half_width_m);
    least.edges_m = std::min(least.edges_m, edge_m - half_width_m);
  }
  return least;
}

}  // namespace

Mover nearest_mover(const memory::ShortTermMemory& memory, double half_lane_m) {
  const memory::LocalGrid& grid = memory.map();
  const int reach = static_cast<int>(kMoversTo_m / memory::LocalGrid::kCell_m);
  const memory::GridCell middle =
      memory::LocalGrid::cell_of({memory.pose().x_m, memory.pose().y_m});
  Mover nearest;
  int cells = 0;
  for (int y = middle.y - reach; y <= middle.y + reach; ++y) {
    for (int x = middle.x - reach; x <= middle.x + reach; ++x) {
      if (grid.moving({x, y}) < kMoves || grid.state({x, y}) != memory::CellState::occupied)
        continue;
      const Point2 place = inverse_transform(memory.pose(), memory::LocalGrid::centre_of({x, y}));
      if (place.x_m < kBeforeAxle_m || std::abs(place.y_m) > half_lane_m) continue;
      ++cells;
      const double distance_m = std::hypot(place.x_m, place.y_m);
      if (distance_m < nearest.distance_m) {
        nearest = {distance_m, std::atan2(place.y_m, place.x_m)};
      }
    }
  }
  return cells >= kMoverPatches ? nearest : Mover{};
}

SpeedLimit speed_limit_for(const SpeedLimitSettings& settings, const RobotDescription& robot,
                           const memory::ShortTermMemory& memory, const FloorField& field,
                           const Path& way) {
  SpeedLimit speed_limit;
  speed_limit.speed_m_s = robot.max_forward_m_s;
  measure_known(field, way, robot.front_m + kUnderBumper_m, speed_limit);
  const double known =
      stopping_speed(speed_limit.known_free_m - robot.front_m - kStopBefore_m,
                     kBrakeShare * robot.max_acceleration_m_s2, settings.latency_s);
  cap(speed_limit, std::max(known, settings.unknown_m_s), "the floor ahead is not seen free");

  const double straight =
      stopping_speed(free_straight_on_m(field, memory.pose(), robot),
                     kBrakeShare * robot.max_acceleration_m_s2, settings.latency_s);
  cap(speed_limit, std::max(straight, settings.unknown_m_s), "it is not free straight on");

  const Margins margins = margins_of_next(field, way, robot.half_width_m);
  const auto roomy = [&robot](double margin_m, double roomy_m, double least_m_s) {
    const double share = std::clamp((margin_m - kNarrowest_m) / (roomy_m - kNarrowest_m), 0.0, 1.0);
    return least_m_s + share * (robot.max_forward_m_s - least_m_s);
  };
  cap(speed_limit, roomy(margins.things_m, settings.roomy_m, settings.narrow_m_s), "it is narrow");
  cap(speed_limit, roomy(margins.edges_m, settings.seen_beside_m, settings.unknown_m_s),
      "little is known beside the way");

  const Mover mover = nearest_mover(memory, kLane_m);
  speed_limit.mover_m = mover.distance_m;
  speed_limit.mover_rad = mover.bearing_rad;
  const double apart = (mover.distance_m - settings.moving_stop_m) /
                       (settings.moving_slow_m - settings.moving_stop_m);
  if (apart < 1.0) {
    speed_limit.waits_for_mover = apart <= 0.0;
    // Between standing and the first speed that gets anywhere there is nothing.
    const double slowed_m_s = std::max(kCreep_m_s, apart * robot.max_forward_m_s * kMoverShare);
    cap(speed_limit, speed_limit.waits_for_mover ? 0.0 : slowed_m_s, "something moves ahead");
  }
  return speed_limit;
}

}  // namespace striate::behaviours
