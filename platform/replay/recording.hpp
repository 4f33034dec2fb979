#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "striate/platform/interface/robot.hpp"

/// What a recording holds. See README.md for the file.
namespace striate::replay {

using NamedText = std::pair<std::string, std::string>;

/// What a run was begun with: once, at the head of the file.
struct RecordedSetup {
  std::string software;               ///< "striate 0.1.0"
  std::string task;                   ///< as it was named on the command line
  std::vector<NamedText> task_files;  ///< the task first, then those it uses; paths below a folder
  std::vector<NamedText> variables;   ///< given to the task from outside
  bool memory_known = false;          ///< there was a long-term memory
  std::vector<std::uint8_t> memory;   ///< its file before the run; empty: it was still to be made
  std::string robot_file;             ///< "": built-in settings
  std::string robot_text;
  std::vector<NamedText> settings;  ///< all in force: key, value as printed
  bool emergency_layer = true;
  std::string world;  ///< "": a real robot
  std::uint64_t seed = 0;
  RobotDescription robot;
};

/// What the robot decided in a cycle, to be compared bit for bit.
struct RecordedDecision {
  MotorCommand wish;
  int progress = 0;  ///< of the wish: 0 running, 1 succeeded, 2 failed
  TimePoint wish_stamp;
  std::string why;           ///< of the wish
  MotorCommand sent;         ///< what the limiter let through
  std::string limited_by;    ///< its reason, in words
  std::string doing;         ///< the action that ran; "": none
  bool interrupted = false;  ///< before this cycle the task had been ended from outside
};

/// One cycle, whole: what was felt and what was decided.
struct RecordedCycle {
  std::uint64_t number = 0;  ///< from 1; where numbers are missing cycles were not kept
  Senses senses;
  RecordedDecision decision;
};

}  // namespace striate::replay
