#include "striate/platform/simulator/judge.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "striate/platform/simulator/obstacle_shapes.hpp"

namespace striate::simulator {
namespace {

/// The physics feels a touch by its own skin of about 2 mm, and not at every grazing pass: what is
/// nearer than that by the exact distance is touched as well.
constexpr double kTouching_m = 0.002;
/// So near it is measured at every step: two steps of 7.5 mm from each side (ours)
constexpr double kWatched_m = 0.03;
constexpr double kNear_m = 0.10;  ///< a near miss: a hand's breadth (ours)
/// A near miss has ended: so much beyond kNear_m that noise ends none (ours)
constexpr double kFarAgain_m = 0.15;
/// Touching again so soon is the same collision: a bounce (ours)
constexpr double kSameTouch_s = 1.0;
constexpr double kPathPeriod_s = 0.2;    ///< between noted poses: 0.15 m at full speed
constexpr double kPeoplePeriod_s = 0.5;  ///< between noted places of people: a step
constexpr double kAlmostDue_s = 1e-9;    ///< sums of 10 ms are not exact: a nanosecond is there
/// Faster than this a thing counts as moving when it was hit: a tenth of a slow walk (ours)
constexpr double kMoving_m_s = 0.05;
// Where the base stands on the floor, in from the outline, m: the wheels of a P3-DX are 0.33 m
// apart and it is 0.425 m wide; its castor runs 0.2 m behind the axle, the rear end is at 0.3 m.
constexpr double kWheelIn_m = 0.0475;
constexpr double kCastorIn_m = 0.1;

/// One of them over an edge, and the base goes down.
std::array<Point2, 3> wheels_of(const RobotDescription& robot) {
  const double beside_m = robot.half_width_m - kWheelIn_m;
  return {{{0.0, beside_m}, {0.0, -beside_m}, {kCastorIn_m - robot.rear_m, 0.0}}};
}

}  // namespace

Judge::Judge(const World& world, const FloorPlan& plan, const RobotDescription& robot,
             const JudgeSettings& settings)
    : plan_(plan),
      things_(solid_shapes(world, plan)),
      drops_(drops(world, plan)),
      footprint_(robot_footprint(robot)),
      wheels_(wheels_of(robot)),
      settings_(settings),
      goal_beyond_m_(world.goal_beyond_m) {
  for (StaticShape& wall : wall_shapes(plan)) things_.push_back(std::move(wall));
}

void Judge::add_obstacles(const World& new_ones) {
  for (StaticShape& thing : solid_shapes(new_ones, plan_)) things_.push_back(std::move(thing));
}

void Judge::look(double now_s, const Physics& physics, const People& people,
                 const ImageSource* light) {
  note_path(now_s, physics, people);
  std::vector<Touch> touches = physics.touches();
  // In 20 ms nothing comes 3 cm nearer.
  const bool measured = looks_++ % 2 == 0 || clearance_m_ < kWatched_m;
  Nearest nearest;
  if (measured) nearest = nearest_thing(people);
  if (touches.empty() && nearest.clearance_m < kTouching_m) {
    touches.push_back({nearest.name, nearest.moving});
  }
  if (const std::string drop = fallen_into(); !drop.empty()) touches.push_back({drop, false});
  note_touches(now_s, touches, light);
  forward_m_s_ = physics.forward_m_s();
  if (!touches.empty()) {
    note_touching();
  } else if (measured) {
    note_clearance(now_s, nearest);
  }
  reached_goal_ = reached_goal_ || in_corridor().x_m > goal_beyond_m_;
  decide(now_s);
}

void Judge::note_path(double now_s, const Physics& physics, const People& people) {
  const Pose2 pose = physics.robot();
  if (started_) {
    driven_m_ += std::hypot(pose.x_m - now_.pose.x_m, pose.y_m - now_.pose.y_m);
  }
  started_ = true;
  now_ = {now_s, pose};
  if (path_.empty() || now_s - path_.back().time_s >= kPathPeriod_s - kAlmostDue_s) {
    path_.push_back(now_);
  }
  if (people_.empty() || now_s - people_.back().time_s >= kPeoplePeriod_s - kAlmostDue_s) {
    people_.push_back({now_s, {}});
    for (const PersonState& person : people.states()) people_.back().people.push_back(person.pose);
  }
}

void Judge::note_touches(double now_s, const std::vector<Touch>& touches,
                         const ImageSource* light) {
  std::erase_if(held_, [&](const Held& held) { return now_s - held.last_s > kSameTouch_s; });
  for (const Touch& touch : touches) {
    const auto same = std::find_if(held_.begin(), held_.end(),
                                   [&](const Held& held) { return held.name == touch.name; });
    if (same != held_.end()) {
      same->last_s = now_s;
      continue;
    }
    held_.push_back({touch.name, now_s});
    const Pose2 at = in_corridor();
    const double level =
        light != nullptr ? light->light_level({now_.pose.x_m, now_.pose.y_m}) : 1.0;
    collisions_.push_back({now_s, at.x_m, at.y_m, touch.name, touch.moving, level, forward_m_s_});
  }
}

std::string Judge::fallen_into() const {
  for (const StaticShape& drop : drops_) {
    for (const Point2 wheel : wheels_) {
      const ConvexShape contact = disc(transform(now_.pose, wheel), 0.0);
      if (distance_m(contact, drop.shape) <= 0.0) return "drop of " + drop.name;
    }
  }
  return "";
}

Judge::Nearest Judge::nearest_thing(const People& people) const {
  const ConvexShape robot = moved(footprint_, now_.pose);
  const Point2 middle{now_.pose.x_m, now_.pose.y_m};
  const double reach = bounding_radius_m(footprint_, {});
  Nearest nearest;
  for (const StaticShape& thing : things_) {
    // A wall is long: its middle tells nothing, the line itself does.
    const std::vector<Point2>& corners = thing.shape.corners;
    const double away = corners.size() == 2 ? distance_to_segment_m(middle, corners[0], corners[1])
                                            : distance_m(middle, thing.middle) - thing.bounding_m;
    if (away - reach > nearest.clearance_m) continue;
    const double clearance = distance_m(robot, thing.shape);
    if (clearance < nearest.clearance_m) nearest = {clearance, thing.name, false};
  }
  for (std::size_t i = 0; i < people.slots().size(); ++i) {
    if (!people.present(i)) continue;
    const PersonState& person = people.slots()[i];
    const Point2 at{person.pose.x_m, person.pose.y_m};
    if (distance_m(middle, at) - kPersonRadius_m - reach > nearest.clearance_m) continue;
    const double clearance = distance_m(robot, disc(at, kPersonRadius_m));
    if (clearance < nearest.clearance_m) {
      nearest = {clearance, people.name(i), person.speed_m_s > kMoving_m_s};
    }
  }
  return nearest;
}

/// This approach has become a collision.
void Judge::note_touching() {
  clearance_m_ = 0.0;
  near_ = false;
}

void Judge::note_clearance(double now_s, const Nearest& nearest) {
  clearance_m_ = nearest.clearance_m;
  nearest_pass_m_ = std::min(nearest_pass_m_, nearest.clearance_m);
  if (nearest.clearance_m < kNear_m && (!near_ || nearest.clearance_m < nearing_.clearance_m)) {
    const Pose2 at = in_corridor();
    nearing_ = {now_s, at.x_m, at.y_m, nearest.clearance_m, nearest.name, nearest.moving};
    near_ = true;
  }
  if (near_ && nearest.clearance_m > kFarAgain_m) {
    near_misses_.push_back(nearing_);
    near_ = false;
  }
}

void Judge::decide(double now_s) {
  if (over_) return;
  if (!collisions_.empty()) {
    outcome_ = Verdict::collided;
    over_ = settings_.ends_at_collision;
  } else if (reached_goal_) {
    outcome_ = Verdict::reached_goal;
  }
  over_ = over_ || (reached_goal_ && settings_.ends_at_goal);
  if (!over_ && settings_.time_limit_s > 0.0 && now_s + kAlmostDue_s >= settings_.time_limit_s) {
    if (outcome_ == Verdict::running) outcome_ = Verdict::time_up;
    over_ = true;
  }
  if (over_ && near_) near_misses_.push_back(nearing_);
}

}  // namespace striate::simulator
