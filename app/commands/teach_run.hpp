#pragma once

#include <string>
#include <vector>

#include "striate/agent/simulated_body.hpp"
#include "striate/app/commands/taught_pictures.hpp"

/// What `striate teach` does with its options.
namespace striate::app {

struct TeachOptions {
  std::string name;
  TaughtPictures pictures;
  std::string memory = "home.db";
  std::string robot;              ///< settings file; empty: the defaults
  std::string task;               ///< with a world: to look at a thing there ...
  agent::WorldOptions live;       ///< ... without them it learns from images
  std::string at;                 ///< where the robot starts; empty: the world's start
  std::string from;               ///< a recording to learn from
  std::vector<std::string> when;  ///< times of it; none: where the robot was taught then
  bool yes = false;               ///< nobody is asked
  bool undo = false;
  bool json = false;
};

/// @return the exit code
[[nodiscard]] int run_teach(const TeachOptions& options);

}  // namespace striate::app
