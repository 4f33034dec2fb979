#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace striate::app {

/// What `striate trial --objects` is asked for.
struct ObjectTrialOptions {
  std::string teach_world = "config/worlds/objects_teach.yaml";
  std::string find_world = "config/worlds/objects_find.yaml";
  std::string task = "config/tasks/teach.yaml";
  std::string look_task = "config/tasks/look.yaml";  ///< what it does while it seeks
  std::string robot = "config/robots/sharp_eyes.yaml";
  std::vector<std::string> only;  ///< objects that are taught and sought; empty: all
  std::string out;                ///< folder for objects.csv and the memory
  std::uint64_t seed = 1;         ///< any; the reported ones are 1 and 2
  bool quiet = false;
};

/// Teaches the objects of one world live and seeks them in another, as the paper did with its
/// eight. Prints the table. @return exit code: 1 where one was not recognised anywhere, or a false
/// alarm
/// @throws UserError for mistakes in what was given
[[nodiscard]] int run_object_trial(const ObjectTrialOptions& options);

}  // namespace striate::app
