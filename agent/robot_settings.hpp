#pragma once

#include <string>
#include <vector>

#include "striate/agent/body_settings.hpp"
#include "striate/agent/plugins/robot_plugins.hpp"
#include "striate/behaviours/control/safety_limiter.hpp"
#include "striate/config/settings.hpp"
#include "striate/memory/long_term/long_term_settings.hpp"
#include "striate/memory/short_term/short_term_memory.hpp"
#include "striate/perception/perception.hpp"
#include "striate/platform/pioneer/pioneer_settings.hpp"
#include "striate/platform/ros/ros_settings.hpp"
#include "striate/platform/rosbridge/bridge_settings.hpp"
#include "striate/platform/simulator/render/renderer.hpp"
#include "striate/platform/simulator/simulated_pioneer.hpp"

namespace striate::agent {

/// Everything that can be set about a robot and its mind: the file that `--robot` names.
struct RobotSettings {
  BodySettings robot;
  perception::PerceptionSettings perception;
  memory::ShortTermMemorySettings memory;
  memory::LongTermSettings long_term_memory;
  behaviours::SafetyLimiterSettings safety;
  simulator::CameraSettings camera;
  simulator::SimulatorSettings simulator;
  pioneer::PioneerSettings pioneer;
  ros::RosSettings ros;
  rosbridge::BridgeSettings rosbridge;
};

template <class V>
void visit(V& v, RobotSettings& s) {
  v.section("robot", s.robot);
  v.section("perception", s.perception);
  v.section("memory", s.memory);
  v.section("long_term_memory", s.long_term_memory);
  v.section("safety", s.safety);
  v.section("camera", s.camera);
  v.section("simulator", s.simulator);
  v.section("pioneer", s.pioneer);
  v.section("ros", s.ros);
  v.section("rosbridge", s.rosbridge);
}

/// The defaults, changed by what the file says; "" is the defaults alone. Loads the plugins that it
/// names (agent/plugins/robot_plugins.hpp).
/// @param warnings takes what is no mistake but should be changed, if not null.
/// @throws UserError with all mistakes of the file.
RobotSettings load_robot_settings(const std::string& file, std::string* warnings = nullptr,
                                  PluginLines lines = PluginLines::load);

/// The simulated robot with its camera, as the settings make it. A real one knows its own camera.
[[nodiscard]] RobotDescription simulated_robot(const RobotSettings& settings);

/// One setting in force and where its value came from.
struct SettingInForce {
  config::SettingLine line;
  std::string origin;  ///< "default" or "file:line"
};

[[nodiscard]] std::vector<SettingInForce> settings_in_force(const std::string& file);

}  // namespace striate::agent
