#pragma once

#include <functional>
#include <string>
#include <vector>

#include "striate/agent/mission.hpp"
#include "striate/app/commands/foxglove_options.hpp"
#include "striate/app/commands/mcap_options.hpp"

namespace striate::app {

/// What `striate run` and `striate ros` are asked for, whatever the body.
struct RunOptions {
  agent::MissionOptions mission;
  std::vector<std::string> given;  ///< "way=20 m"
  bool no_emergency = false;
  std::string world;   ///< file that the body is of; empty: none
  std::string memory;  ///< long-term memory; empty: none
  std::string record;  ///< recording; empty: none
  McapOptions mcap;
  FoxgloveOptions foxglove;
  bool real_time = false;  ///< not faster than the clock on the wall
  std::string inspect;     ///< short-term memory once a second; empty: none
  std::string pictures;    ///< folder for images of the run; empty: none
  int picture_every = 0;   ///< an overview image every so many cycles; 0: none
  std::string result;      ///< JSON file; empty: none
  bool quiet = false;
  bool json = false;
  /// Who else looks at the run, and may drive: called once before it, and after each cycle.
  std::function<void(agent::Mission&)> at_begin;
  std::function<void(const agent::Mission&)> each_cycle;
};

/// Runs the task to its end with that body, watched by all that was asked for. @returns the exit
/// code. @throws UserError, std::runtime_error before anything moves, see prepare()
int run_mission(const RunOptions& options, const agent::BodySource& body);

}  // namespace striate::app
