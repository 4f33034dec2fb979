#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>

#include "striate/platform/ros/ros_robot.hpp"
#include "tests/reference/temporary_folder.hpp"
#include "tests/scenarios/ros/ros_master.hpp"

/// Robots through a real ROS master: what one `striate` shows, another one, or a test, drives.
namespace striate::scenarios {

using namespace std::chrono_literals;
using Steady = std::chrono::steady_clock;

/// A small camera and short patience; vision alone is not the point here.
constexpr const char* kSettings =
    "camera: {width: 160}\n"
    "ros: {lost: 1.5 s}\n";

inline std::string text_of(const std::string& file) {
  std::stringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

class ThroughRos : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    if (!RosMaster::installed()) return;
    folder = std::make_unique<reference::TemporaryFolder>();
    master = std::make_unique<RosMaster>(folder->path());
    ASSERT_TRUE(master->answers());
    robot_file = folder->write("robot.yaml", kSettings);
  }
  static void TearDownTestSuite() {
    master.reset();
    folder.reset();
  }
  void SetUp() override {
    ASSERT_TRUE(master) << "rosmaster is missing: apt-get install python3-rosmaster, or build "
                           "without ROS: -DSTRIATE_ROS=OFF";
  }

  static std::unique_ptr<Program> serve(const std::string& world) {
    return std::make_unique<Program>(
        std::vector<std::string>{STRIATE_BINARY, "ros", "serve", "--world", world, "--robot",
                                 robot_file},
        log("serve"));
  }
  static std::unique_ptr<Program> mission(const std::string& way) {
    return std::make_unique<Program>(
        std::vector<std::string>{STRIATE_BINARY, "ros", "run", "config/tasks/corridor.yaml",
                                 "--robot", robot_file, "--var", "way=" + way},
        log("mission"));
  }
  static std::string log(const std::string& name) { return *folder / (name + ".log"); }
  static ros::RosSettings settings() {
    ros::RosSettings settings;
    settings.lost_s = 1.5;
    return settings;
  }

  static inline std::unique_ptr<reference::TemporaryFolder> folder;
  static inline std::unique_ptr<RosMaster> master;
  static inline std::string robot_file;
};

/// Senses until it holds or the limit is over. @returns the seconds that it took
template <class Holds>
double until(ros::RosRobot& robot, Senses& senses, double limit_s, const Holds& holds) {
  const auto begin = Steady::now();
  double took_s = 0.0;
  do {
    robot.sense(senses);
    took_s = std::chrono::duration<double>(Steady::now() - begin).count();
  } while (!holds() && took_s < limit_s);
  return took_s;
}

inline bool stands(const Senses& senses) {
  return std::abs(senses.odometry.forward_m_s) < 0.01 &&
         std::abs(senses.odometry.turn_rad_s) < 0.02;
}

}  // namespace striate::scenarios
