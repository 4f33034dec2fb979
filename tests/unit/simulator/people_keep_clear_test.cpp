#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "striate/platform/simulator/obstacle_shapes.hpp"
#include "striate/platform/simulator/people.hpp"
#include "striate/platform/simulator/simulated_pioneer.hpp"
#include "striate/platform/simulator/world_reader.hpp"

namespace striate::simulator {
namespace {

/// The corridors with their people and doors, but nothing else in the way.
World shipped_without_things(const std::string& name) {
  World world = load_world(STRIATE_SOURCE_DIR "/config/worlds/" + name + ".yaml");
  world.obstacles.clear();
  world.pillars.clear();
  world.standers.clear();
  return world;
}

double clearance_m(const People& people, const Pose2& robot) {
  const ConvexShape body = moved(robot_footprint(RobotDescription{}), robot);
  double nearest = std::numeric_limits<double>::infinity();
  for (const PersonState& person : people.states()) {
    nearest = std::min(nearest,
                       distance_m(body, disc({person.pose.x_m, person.pose.y_m}, kPersonRadius_m)));
  }
  return nearest;
}

/// The smallest clearance in ten minutes round a robot that stays where it is.
double nearest_in_ten_minutes_m(const World& world, Pose2 robot, double spin_rad_s,
                                std::uint64_t seed) {
  const FloorPlan plan = build_floor_plan(world);
  People people(world, plan, RobotDescription{}, seed);
  double nearest = std::numeric_limits<double>::infinity();
  for (int step = 1; step <= 60000; ++step) {
    robot.heading_rad = wrap_angle(robot.heading_rad + 0.01 * spin_rad_s);
    people.step(0.01 * step, 0.01, {robot, 0.0, spin_rad_s});
    if (step % 5 == 0) nearest = std::min(nearest, clearance_m(people, robot));
  }
  return nearest;
}

TEST(People, NeverTouchAStandingRobotInTenMinutes) {
  double nearest_of_all = std::numeric_limits<double>::infinity();
  std::uint64_t seed = 1;
  for (const char* name : {"corridor_a", "corridor_b", "corridor_c"}) {
    const World world = shipped_without_things(name);
    for (const Pose2& robot : {Pose2{13.0, 0.0, 0.0}, Pose2{18.6, 0.1, 0.3}, Pose2{24.0, 0.6, 1.57},
                               Pose2{33.5, -0.5, 3.0}, Pose2{50.0, -0.7, -2.0}}) {
      const double nearest = nearest_in_ten_minutes_m(world, robot, 0.0, seed++);
      EXPECT_GT(nearest, 0.10) << name << " at " << robot.x_m << " seed " << seed - 1;
      nearest_of_all = std::min(nearest_of_all, nearest);
    }
  }
  EXPECT_LT(nearest_of_all, 0.6) << "somebody passed the robot, or this test says nothing";
}

TEST(People, NeverTouchARobotThatTurnsOnTheSpot) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const World world = shipped_without_things("corridor_b");
    EXPECT_GT(nearest_in_ten_minutes_m(world, {20.0, 0.1, 0.0}, 0.7, seed), 0.05) << seed;
  }
}

/// A robot that keeps the middle and brakes for whoever is in its lane, but never goes round: what
/// people do to it is their doing.
class BrakingRobot {
 public:
  BrakingRobot(const World& world, std::uint64_t seed, bool brakes)
      : robot_(world, seed, settings(), nullptr), brakes_(brakes) {}

  Verdict drive(double speed_m_s) {
    Senses senses;
    SceneState seen = robot_.scene();
    while (robot_.sense(senses)) {
      const SceneState now = robot_.scene();
      // Decides on what an image of 85 ms ago shows, as a robot does.
      const bool stop = brakes_ && in_lane(seen, stopping_distance_m(speed_m_s, {}) + 0.15);
      const Pose2 at = robot_.judge().in_corridor();
      robot_.send({.forward_m_s = stop ? 0.0 : speed_m_s,
                   .turn_rad_s = -0.8 * at.heading_rad - 0.3 * at.y_m});
      seen = now;
    }
    return robot_.judge().outcome();
  }
  [[nodiscard]] const SimulatedPioneer& robot() const { return robot_; }

 private:
  static SimulatorSettings settings() {
    SimulatorSettings settings;
    settings.judge.time_limit_s = 400.0;
    return settings;
  }
  static bool in_lane(const SceneState& scene, double within_m) {
    for (const PersonState& person : scene.people) {
      const Point2 at = inverse_transform(scene.robot, Point2{person.pose.x_m, person.pose.y_m});
      const double gap = at.x_m - RobotDescription{}.front_m - kPersonRadius_m;
      if (at.x_m > 0.0 && gap < within_m && std::abs(at.y_m) < 0.55) return true;
    }
    return false;
  }
  SimulatedPioneer robot_;
  bool brakes_;
};

TEST(People, LeaveABrakingRobotRoomToStop) {
  int goals = 0;
  int runs = 0;
  for (const char* name : {"corridor_a", "corridor_b", "corridor_c"}) {
    const World world = shipped_without_things(name);
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      BrakingRobot robot(world, seed, true);
      const Verdict outcome = robot.drive(seed % 2 == 0 ? 0.4 : 0.7);
      ++runs;
      goals += outcome == Verdict::reached_goal;
      for (const Collision& collision : robot.robot().judge().collisions()) {
        ADD_FAILURE() << name << " seed " << seed << ": " << collision.hit << " at "
                      << collision.along_m << " after " << collision.time_s << " s";
      }
    }
  }
  EXPECT_EQ(goals, runs) << "nobody blocks the way for ever";
}

TEST(People, NeverRunIntoARobotFromBehindOrFromTheSide) {
  // This robot never brakes. Whom it touches, it touches with its front.
  int touched = 0;
  for (const char* name : {"corridor_a", "corridor_b", "corridor_c"}) {
    const World world = shipped_without_things(name);
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      BrakingRobot robot(world, seed, false);
      if (robot.drive(0.3) != Verdict::collided) continue;
      ++touched;
      const SceneState scene = robot.robot().scene();
      double nearest = 1e9;
      Point2 hit;
      for (const PersonState& person : scene.people) {
        const Point2 at = inverse_transform(scene.robot, Point2{person.pose.x_m, person.pose.y_m});
        if (std::hypot(at.x_m, at.y_m) < nearest) {
          nearest = std::hypot(at.x_m, at.y_m);
          hit = at;
        }
      }
      EXPECT_GT(hit.x_m, RobotDescription{}.front_m) << name << " seed " << seed;
    }
  }
  EXPECT_GT(touched, 0) << "a blind robot meets somebody";
}

TEST(People, StepInFrontOfTheRobotAndGoAwayAgain) {
  World world;
  world.length_m = 60.0;
  world.goal_beyond_m = 55.0;
  for (int i = 0; i < 10; ++i) {
    world.doors.push_back({i % 2 == 0 ? Side::left : Side::right, 4.0 + 5.0 * i});
  }
  world.steps_in_front.push_back({3.0, 3.0});
  int stops = 0;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    BrakingRobot robot(world, seed, true);
    ASSERT_EQ(robot.drive(0.4), Verdict::reached_goal) << "seed " << seed;
    // Every stop of the way is somebody who stood before the robot.
    const auto& path = robot.robot().judge().path();
    bool stood = false;
    for (std::size_t i = 20; i < path.size(); ++i) {
      const bool stands = distance_m({path[i].pose.x_m, path[i].pose.y_m},
                                     {path[i - 1].pose.x_m, path[i - 1].pose.y_m}) < 0.002;
      stops += stands && !stood;
      stood = stands;
    }
  }
  EXPECT_GE(stops, 5);
}

TEST(People, StepInFrontEvenWhereNoDoorIs) {
  World world;
  world.length_m = 60.0;
  world.goal_beyond_m = 55.0;
  world.steps_in_front.push_back({3.0, 2.0});
  const FloorPlan plan = build_floor_plan(world);
  int met = 0;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    BrakingRobot robot(world, seed, true);
    ASSERT_EQ(robot.drive(0.4), Verdict::reached_goal) << "seed " << seed;
    double nearest = 1e9;
    for (const PeopleAt& moment : robot.robot().judge().people()) {
      for (const Pose2& person : moment.people) {
        for (const PathPoint& point : robot.robot().judge().path()) {
          if (std::abs(point.time_s - moment.time_s) > 0.11) continue;
          nearest = std::min(
              nearest, distance_m({person.x_m, person.y_m}, {point.pose.x_m, point.pose.y_m}));
        }
      }
    }
    met += nearest < 3.0;
  }
  EXPECT_GE(met, 4);
}

}  // namespace
}  // namespace striate::simulator
