#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "striate/agent/body_settings.hpp"
#include "striate/agent/robot_settings.hpp"
#include "striate/platform/pioneer/pioneer_robot.hpp"
#include "tests/scenarios/served_hall.hpp"
#include "tests/scenarios/striate_process.hpp"

/// Every kind of Pioneer, served as such and met by our driver, which knows it by its name alone.
namespace striate::scenarios {
namespace {

/// The shipped outline of a kind.
RobotDescription body_of(const std::string& kind) {
  const std::string name = kind.substr(0, kind.find('-'));
  if (name == "p3dx") return {};
  const std::string file = name == "amigo" ? "amigobot" : name;
  return agent::simulated_robot(
      agent::load_robot_settings(kRoot + "config/robots/" + file + ".yaml"));
}

class Kinds : public testing::TestWithParam<std::string> {};

TEST_P(Kinds, AreDrivenByTheirOwnFactorsAndSeeByTheirOwnSonar) {
  served::ServedDevices devices;
  devices.base.subclass = GetParam();
  const Served served({}, devices, body_of(GetParam()));
  pioneer::PioneerRobot robot({}, served.url());
  ASSERT_THAT(robot.driver().report().robot, testing::HasSubstr(GetParam()));
  Senses senses;
  robot.sense(senses);
  const Pose2 from = senses.odometry.pose;
  const Pose2 true_from = served.state().true_pose;
  // A bend: the factors of the way, of the wheels' speeds and of the half axle all count.
  double turned_rad = 0.0;
  double driven_m = 0.0;
  for (int i = 0; i < 25; ++i) {
    robot.send({.forward_m_s = 0.3, .turn_rad_s = 0.3});
    robot.sense(senses);
    turned_rad += 0.1 * senses.odometry.turn_rad_s;
    driven_m += 0.1 * senses.odometry.forward_m_s;
  }
  for (int i = 0; i < 15; ++i) {
    robot.send({});
    robot.sense(senses);
    turned_rad += 0.1 * senses.odometry.turn_rad_s;
    driven_m += 0.1 * senses.odometry.forward_m_s;
  }
  const Pose2 true_to = served.state().true_pose;
  const Pose2 seen = inverse_transform(from, senses.odometry.pose);
  const Pose2 truth = inverse_transform(true_from, true_to);
  EXPECT_GT(truth.heading_rad, 0.4);
  EXPECT_NEAR(seen.x_m, truth.x_m, 0.04);
  EXPECT_NEAR(seen.y_m, truth.y_m, 0.04);
  EXPECT_NEAR(seen.heading_rad, truth.heading_rad, 0.05);
  EXPECT_NEAR(turned_rad, truth.heading_rad, 0.15);
  EXPECT_NEAR(driven_m, std::hypot(truth.x_m, truth.y_m), 0.15);

  // What the discs say lies on the hall's walls, wherever the kind's discs sit.
  const pioneer::RobotModel& model = *pioneer::find_model(GetParam());
  const simulator::World world = hall();
  int echoes = 0;
  for (const RangeReading& reading : senses.sonar.readings) {
    if (!std::isfinite(reading.distance_m)) continue;
    const Point2 there =
        transform(true_to, Point2{reading.distance_m * std::cos(reading.bearing_rad),
                                  reading.distance_m * std::sin(reading.bearing_rad)});
    const double to_side_m = std::abs(std::abs(there.y_m) - 0.5 * world.width_m);
    const double to_end_m = std::min(std::abs(there.x_m), std::abs(there.x_m - world.length_m));
    // A beam 25 degrees wide meets a slanting wall up to this much before its middle does; another
    // kind's discs look to other sides and would be metres off.
    EXPECT_LT(std::min(to_side_m, to_end_m), 0.2) << there.x_m << " m, " << there.y_m << " m";
    ++echoes;
  }
  EXPECT_EQ(senses.sonar.readings.size(), model.discs.size());
  EXPECT_GE(echoes, 2) << "some discs look at a wall";
}

std::string title_of(const testing::TestParamInfo<std::string>& kind) {
  std::string title = kind.param;
  std::replace(title.begin(), title.end(), '-', '_');
  return title;
}
INSTANTIATE_TEST_SUITE_P(Known, Kinds, testing::ValuesIn(pioneer::model_names()), title_of);

}  // namespace
}  // namespace striate::scenarios
