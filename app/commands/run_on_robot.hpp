#pragma once

#include <functional>
#include <string>

#include "app/robot_mission.hpp"

namespace striate {

/// `striate run TASK --robot FILE`, without a world: the robot is a real one.
struct RunOnRobotOptions {
  RobotMissionOptions mission;
  std::string memory;   ///< long-term memory; empty: none
  std::string record;   ///< recording; empty: none
  std::string inspect;  ///< short-term memory once a second; empty: none
  std::string result;
  bool quiet = false;
  bool json = false;
  /// Who else looks at the run, and may drive: called once before it, and after each cycle.
  std::function<void(RobotMission&)> at_begin;
  std::function<void(const RobotMission&)> each_cycle;
};

/// Runs the task to its end. @returns the exit code.
int run_on_robot(const RunOnRobotOptions& options);

}  // namespace striate
