#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "behaviours/behaviour.hpp"
#include "config/mistakes.hpp"
#include "platform/interface/time.hpp"
#include "tasks/condition.hpp"

namespace striate {

struct Step;

/// What to do when a step fails, before it is tried again.
struct Recovery {
  int tries = 1;  ///< how often the step may be tried again, >= 1
  std::vector<Step> steps;
};

/// One action of a task script with its goal detector, time limit and recovery.
struct Step {
  std::string action;   ///< name of the behaviour
  config::Place place;  ///< in the script, for reports
  std::unique_ptr<Behaviour> behaviour;
  std::unique_ptr<Condition> until;       ///< nullptr: the action ends by itself
  std::optional<Duration> within;         ///< longer than this is a failure
  std::unique_ptr<Recovery> if_it_fails;  ///< nullptr: a failure ends the task
};

/// A task script, checked and ready to run once.
struct Task {
  std::string file;
  std::string mission;
  std::vector<Step> steps;    ///< `do`: one after the other
  std::vector<Step> finally;  ///< run after every ending, each whatever the others did
};

}  // namespace striate
