#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "striate/platform/simulator/dead_reckoning.hpp"
#include "striate/platform/simulator/physics.hpp"
#include "striate/platform/simulator/random.hpp"
#include "striate/platform/simulator/range_finders.hpp"
#include "tests/unit/simulator/fake_images.hpp"

namespace striate::simulator {
namespace {

struct Covariance {
  double mean = 0.0;
  double deviation = 0.0;
};

Covariance spread(const std::vector<double>& values) {
  Covariance result;
  for (const double value : values) result.mean += value / static_cast<double>(values.size());
  for (const double value : values) {
    result.deviation +=
        (value - result.mean) * (value - result.mean) / static_cast<double>(values.size());
  }
  result.deviation = std::sqrt(result.deviation);
  return result;
}

TEST(Random, DrawsWhatItSays) {
  const Random random(3, Purpose::sonar);
  std::vector<double> uniform;
  std::vector<double> normal;
  for (std::uint64_t i = 0; i < 20000; ++i) {
    uniform.push_back(random.uniform(i));
    normal.push_back(random.normal(i));
    ASSERT_GE(uniform.back(), 0.0);
    ASSERT_LT(uniform.back(), 1.0);
  }
  EXPECT_NEAR(spread(uniform).mean, 0.5, 0.01);
  EXPECT_NEAR(spread(uniform).deviation, std::sqrt(1.0 / 12.0), 0.005);
  EXPECT_NEAR(spread(normal).mean, 0.0, 0.03);
  EXPECT_NEAR(spread(normal).deviation, 1.0, 0.02);
  EXPECT_EQ(random.uniform(17), Random(3, Purpose::sonar).uniform(17));
  EXPECT_NE(random.uniform(17), Random(3, Purpose::laser).uniform(17));
  EXPECT_NE(random.uniform(17), Random(4, Purpose::sonar).uniform(17));
}

TEST(DeadReckoning, ErrsByThreeQuartersOfAPercentOfWayAndTurn) {
  std::vector<double> way_errors;
  std::vector<double> turn_errors;
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    DeadReckoning straight(seed, SensorSettings{});
    for (int i = 0; i < 5000; ++i) straight.step(0.01, 0.4, 0.0);
    const Odometry way = straight.reported({});
    way_errors.push_back(std::hypot(way.pose.x_m, way.pose.y_m) / 20.0 - 1.0);
    DeadReckoning turning(seed, SensorSettings{});
    for (int i = 0; i < 600; ++i) turning.step(0.01, 0.0, 0.5);
    turn_errors.push_back(turning.reported({}).pose.heading_rad / 3.0 - 1.0);
  }
  EXPECT_NEAR(spread(way_errors).deviation, 0.0075, 0.0010);
  EXPECT_NEAR(spread(way_errors).mean, 0.0, 0.0015);
  EXPECT_NEAR(spread(turn_errors).deviation, 0.0075, 0.0010);
  EXPECT_NEAR(spread(turn_errors).mean, 0.0, 0.0015);
}

TEST(DeadReckoning, DriftsOffTheStraightLineByLessThanHalfAMetreIn20) {
  std::vector<double> sideways;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    DeadReckoning straight(seed, SensorSettings{});
    for (int i = 0; i < 5000; ++i) straight.step(0.01, 0.4, 0.0);
    sideways.push_back(straight.reported({}).pose.y_m);
  }
  EXPECT_GT(spread(sideways).deviation, 0.05);
  EXPECT_LT(spread(sideways).deviation, 0.25);
}

class RangeFinders : public testing::Test {
 protected:
  Physics physics_at(const World& world, Pose2 robot) {
    const FloorPlan plan = build_floor_plan(world);
    return Physics(world, plan, RobotDescription{}, robot, 0);
  }
  static SensorSettings exact() {
    SensorSettings settings;
    settings.laser_noise_m = 0.0;
    return settings;
  }
};

TEST_F(RangeFinders, SitAtTheRimOfTheOutline) {
  EXPECT_EQ(sonar_mounts({})[3].x_m, 0.166);
  RobotDescription wide;
  wide.half_width_m *= 1.5;
  wide.front_m *= 2.0;
  EXPECT_NEAR(sonar_mounts(wide)[0].y_m, 1.5 * 0.136, 1e-12);
  EXPECT_NEAR(sonar_mounts(wide)[3].x_m, 2.0 * 0.166, 1e-12);
  EXPECT_EQ(sonar_mounts(wide)[12].x_m, -0.255) << "the rear end is where it was";
  EXPECT_EQ(sonar_mounts(wide)[3].heading_rad, radians(10.0));
  EXPECT_NEAR(laser_mount(wide).x_m, 0.042, 1e-12);
}

TEST_F(RangeFinders, DiscsSitWhereTheRobotSaysArrayByArray) {
  RobotDescription robot;
  robot.sonar_discs.assign(24, Pose2{0.1, 0.0, 0.3});
  ASSERT_EQ(sonar_mounts(robot).size(), 24u);
  EXPECT_EQ(sonar_mounts(robot)[23].heading_rad, 0.3);
  const TimePoint stamp{std::chrono::milliseconds(40)};
  EXPECT_EQ(discs_fired_at(stamp, 3), (std::vector<std::size_t>{5, 13, 21}));
  EXPECT_EQ(discs_fired_at(stamp, 1), (std::vector<std::size_t>{5}));
  EXPECT_EQ(Sonar(1, exact(), robot).scan().readings.size(), 24u);
}

TEST_F(RangeFinders, TheSideSonarsSeeTheWallsSquareOn) {
  const World world = straight_world();
  const Physics physics = physics_at(world, {10.0, 0.2, 0.0});
  Sonar sonar(1, exact());
  for (int i = 0; i < 40; ++i) sonar.step(0.01 * i, physics);
  ASSERT_EQ(sonar.scan().readings.size(), 16u);
  const RangeReading& left = sonar.scan().readings[0];
  const RangeReading& right = sonar.scan().readings[7];
  EXPECT_NEAR(left.distance_m * std::sin(left.bearing_rad), 1.0, 0.04);
  EXPECT_NEAR(left.distance_m * std::cos(left.bearing_rad), 0.069, 0.002);
  EXPECT_NEAR(right.distance_m * std::sin(right.bearing_rad), -1.4, 0.04);
  EXPECT_TRUE(std::isinf(sonar.scan().readings[3].distance_m)) << "9 m is beyond its range";
}

TEST_F(RangeFinders, ASmoothWallThrowsSlantedSoundAway) {
  const World world = straight_world();
  const Physics physics = physics_at(world, {10.0, 0.0, 0.0});
  Sonar sonar(1, exact());
  for (int i = 0; i < 40; ++i) sonar.step(0.01 * i, physics);
  EXPECT_TRUE(std::isinf(sonar.scan().readings[2].distance_m)) << "30 deg ahead: a mirror";
}

TEST_F(RangeFinders, TheFrontSonarsSeeABoxAhead) {
  World world = straight_world();
  WorldObstacle box;
  box.kind = ObstacleKind::box;
  box.name = "box";
  box.at = {12.0, 0.0};
  world.obstacles.push_back(box);
  const Physics physics = physics_at(world, {10.0, 0.0, 0.0});
  Sonar sonar(1, exact());
  for (int i = 0; i < 40; ++i) sonar.step(0.01 * i, physics);
  const RangeReading& ahead = sonar.scan().readings[3];
  EXPECT_NEAR(ahead.distance_m, 1.75, 0.08);
  EXPECT_NEAR(ahead.bearing_rad, radians(10.0), 0.1);
}

TEST_F(RangeFinders, EachSonarFiresOnceIn320Milliseconds) {
  const World world = straight_world();
  const Physics physics = physics_at(world, {10.0, 0.0, 0.0});
  Sonar sonar(1, exact());
  std::vector<RangeReading> before = sonar.scan().readings;
  std::vector<int> changed(16, 0);
  for (int i = 0; i < 64; ++i) {  // 0.64 s: twice round
    sonar.step(0.01 * i, physics);
    int now = 0;
    for (std::size_t disc = 0; disc < 16; ++disc) {
      if (sonar.scan().readings[disc].distance_m == before[disc].distance_m) continue;
      ++changed[disc];
      ++now;
    }
    EXPECT_LE(now, 2) << "one disc of each array at a time";
    before = sonar.scan().readings;
  }
  for (const std::size_t disc : {0u, 7u, 8u, 15u}) EXPECT_EQ(changed[disc], 2);
}

TEST_F(RangeFinders, TheLaserMeasuresFromTheAxle) {
  const World world = straight_world();
  const Physics physics = physics_at(world, {15.0, 0.0, 0.0});
  Laser laser(1, exact());
  const RangeScan scan = laser.sweep(TimePoint(std::chrono::seconds(3)), physics);
  ASSERT_EQ(scan.readings.size(), 181u);
  EXPECT_EQ(scan.stamp, TimePoint(std::chrono::seconds(3)));
  EXPECT_NEAR(scan.readings[90].distance_m, 5.0, 1e-4);
  EXPECT_NEAR(scan.readings[90].bearing_rad, 0.0, 1e-9);
  for (const RangeReading& reading : scan.readings) {
    const double y = reading.distance_m * std::sin(reading.bearing_rad);
    const double x = reading.distance_m * std::cos(reading.bearing_rad);
    EXPECT_TRUE(std::abs(std::abs(y) - 1.2) < 1e-3 || std::abs(x - 5.0) < 1e-3);
  }
}

TEST_F(RangeFinders, TheLaserLooksUnderATable) {
  World world = straight_world();
  WorldObstacle table;
  table.kind = ObstacleKind::table;
  table.name = "table";
  table.at = {12.0, 0.0};
  world.obstacles.push_back(table);
  const Physics physics = physics_at(world, {10.0, 0.0, 0.0});
  Laser laser(1, exact());
  const RangeScan scan = laser.sweep({}, physics);
  EXPECT_TRUE(std::isinf(scan.readings[90].distance_m)) << "between the legs";
  int legs = 0;
  for (const RangeReading& reading : scan.readings) {
    const double y = reading.distance_m * std::sin(reading.bearing_rad);
    legs += reading.distance_m < 2.7 && std::abs(y) < 0.4;
  }
  EXPECT_GE(legs, 2);
}

}  // namespace
}  // namespace striate::simulator
