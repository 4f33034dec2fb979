#pragma once

#include <pybind11/pybind11.h>

#include <cstdint>
#include <optional>
#include <string>

#include "striate/agent/run_result.hpp"
#include "striate/base/geometry.hpp"
#include "striate/tasks/task_reader.hpp"

namespace striate::python {

/// What a mission from Python is asked for; names as the command line knows them.
struct MissionRequest {
  std::string task;
  std::string world;  ///< empty: the robot is the one that `robot` tells of
  std::uint64_t seed = 1;
  std::string robot;
  std::string memory;
  std::string record;
  std::string result;
  std::string baseline;
  tasks::GivenVariables variables;
  bool emergency = true;
  bool real_time = false;
  bool hears_signals = true;  ///< it runs in the main thread, where Python hears of Ctrl-C
  std::optional<Pose2> start;
  pybind11::object each_cycle;  ///< None: nobody looks on
  pybind11::object pilot;       ///< None: nobody else drives
};

struct MissionOutcome {
  agent::RunResult result;
  std::string json;     ///< as `striate run --result` writes it
  std::string losses;   ///< what could not be written down, a line each; "" for nothing
  std::string notices;  ///< what was read but should be written otherwise; "" for nothing
};

/// Drives it to its end, with the wheels at a stand in the end, however that comes about. Holds the
/// interpreter's lock only while Python's own code runs and, where it hears signals, for a moment
/// each cycle.
/// @throws UserError before anything moves; what Python's code raised, with its traceback; and
/// KeyboardInterrupt, at the end of the cycle in which Ctrl-C was pressed
[[nodiscard]] MissionOutcome run_mission(const MissionRequest& request);

}  // namespace striate::python
