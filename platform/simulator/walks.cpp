#include <algorithm>
#include <cmath>

#include "striate/platform/simulator/obstacle_shapes.hpp"
#include "striate/platform/simulator/people.hpp"

namespace striate::simulator {
namespace {

constexpr double kPatience_s = 4.0;  ///< held up for so long, a walker makes room (ours)
/// From going back to trying again (ours)
constexpr double kYield_s = 8.0;
/// Nearer to the robot nobody appears out of nothing: seven times its way to stop
constexpr double kAppear_m = 4.0;

/// By seed: a share of the speed, seconds of the start, metres along and across (ours). Runs
/// differ, but nobody walks another way than the world file means.
constexpr double kSlowest = 0.85, kFastest = 1.15;
/// Latest start after the given one, s: some metres of way (ours).
constexpr double kLatest_s = 8.0;
/// Points of a walk differ by no more along the corridor: a step's half (ours).
constexpr double kAlong_m = 0.3;
/// And across it: less than the room beside a person in a narrow corridor (ours).
constexpr double kAcross_m = 0.15;
/// Nobody appears nearer to another: two radii and a step (ours).
constexpr double kFreeToAppear_m = 1.0;
/// A door within this is looked for at the end of a way: the doors of the worlds are nearer (ours).
constexpr double kDoorWithin_m = 20.0;

/// A way through the corridor's points that goes round what stands there; where a leg has no free
/// way its end is left out.
std::vector<Point2> free_way(const std::vector<Point2>& points, const ClearanceMap& map) {
  std::vector<Point2> way{points.front()};
  for (std::size_t i = 1; i < points.size(); ++i) {
    const auto leg = map.way(way.back(), points[i], kPersonRoom_m);
    if (leg) way.insert(way.end(), leg->begin() + 1, leg->end());
  }
  return way;
}

}  // namespace

void People::add_walks(std::uint64_t seed) {
  const Random random(seed, Purpose::walk);
  std::uint64_t draw = 0;
  for (const Walk& walk : world_.walks) {
    Walking walking;
    walking.slot = walks_.size();
    walking.speed_m_s = walk.speed_m_s * random.between(draw++, kSlowest, kFastest);
    walking.from_s = walk.from_s + random.between(draw++, 0.0, kLatest_s);
    walking.repeat = walk.repeat;
    walking.look = static_cast<int>(random.bits(draw++) % 64);
    std::vector<Point2> points = walk.points;
    for (Point2& point : points) {
      const Point2 given = point;
      point.x_m += random.between(draw++, -kAlong_m, kAlong_m);
      point.y_m += random.between(draw++, -kAcross_m, kAcross_m);
      const Pose2 pose = plan_.at(point.x_m, point.y_m);
      if (map_.at({pose.x_m, pose.y_m}) < kPersonRoom_m) point = given;
    }
    walking.way = free_way(plan_path(world_, plan_, points), map_);
    walking.done = walking.way.size() < 2;
    walks_.push_back(std::move(walking));
  }
}

void People::decide_walk(Walking& walking, double now_s) {
  if (walking.done || (!walking.walker.present() && !appear(walking, now_s))) return;
  if (walking.walker.held_up_s() > kPatience_s) yield(walking, now_s);
  if (walking.walker.arrived()) {
    if (!walking.yielding) {
      end_of_path(walking);
    } else if (now_s - walking.yielded_at_s > kYield_s) {
      walking.yielding = false;
      walking.walker.go(walking.after, walking.speed_m_s, walking.after_doors);
    }
  }
  if (walking.walker.present()) walking.walker.decide(around_);
}

bool People::appear(Walking& walking, double now_s) {
  const Point2& from = walking.way.front();
  if (now_s < walking.from_s) return false;
  if (distance_m(from, {around_.robot.x_m, around_.robot.y_m}) < kAppear_m) return false;
  for (std::size_t slot = 0; slot < slots_.size(); ++slot) {
    const Walker* other = walker_of(slot);
    if (other->present() && distance_m(from, other->at()) < kFreeToAppear_m) return false;
  }
  const Point2& next = walking.way[1];
  walking.walker.appear({from.x_m, from.y_m, std::atan2(next.y_m - from.y_m, next.x_m - from.x_m)},
                        walking.look);
  walking.walker.go(walking.way, walking.speed_m_s);
  return true;
}

void People::end_of_path(Walking& walking) {
  Walker& walker = walking.walker;
  if (walking.leaving) {
    walker.vanish();
    walking.done = true;
  } else if (walking.repeat) {
    std::reverse(walking.way.begin(), walking.way.end());
    walker.go(walking.way, walking.speed_m_s);
  } else if (auto out = way_out(walker.at(), doors_, map_, kDoorWithin_m)) {
    walking.leaving = true;
    walking.after_doors = {out->door};
    walker.go(std::move(out->way), walking.speed_m_s, walking.after_doors);
  } else {  // he stays where his way ends
    walking.done = true;
    walker.stand();
  }
}

/// Robot and person stand before each other and neither can pass: the person goes back a little to
/// the side, waits, and tries again.
void People::yield(Walking& walking, double now_s) {
  Walker& walker = walking.walker;
  const Point2 here = walker.at();
  const Pose2 robot = plan_.along(around_.robot);
  const Pose2 me = plan_.along({here.x_m, here.y_m, 0.0});
  if (!walking.yielding) walking.after = walker.rest_of_path();
  if (walking.after.size() < 2) return;
  const double away = me.x_m >= robot.x_m ? 1.0 : -1.0;
  for (const double back : {2.5, 1.5, 0.8}) {
    for (const double left : {0.8, -0.8, 0.5, -0.5}) {
      const Pose2 pose = plan_.at(me.x_m + away * back, me.y_m >= 0.0 ? left : -left);
      if (map_.at({pose.x_m, pose.y_m}) < kPersonRoom_m) continue;
      auto way = map_.way(here, {pose.x_m, pose.y_m}, kPersonRoom_m);
      if (!way) continue;
      walking.yielding = true;
      walking.yielded_at_s = now_s;
      walker.go(std::move(*way), walking.speed_m_s);
      return;
    }
  }
}

}  // namespace striate::simulator
