#pragma once

#include <string>

#include "striate/agent/mission.hpp"
#include "striate/agent/simulated_body.hpp"
#include "tests/scenarios/striate_process.hpp"

namespace striate::scenarios {

/// A task that is shipped, by its file's name.
inline agent::MissionOptions shipped_task(const std::string& file) {
  agent::MissionOptions options;
  options.task = kRoot + "config/tasks/" + file;
  return options;
}

inline agent::BodySource in_short_world() {
  return agent::simulated_pioneer({.world = kRoot + "config/worlds/short.yaml", .seed = 3});
}

}  // namespace striate::scenarios
