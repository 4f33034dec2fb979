#pragma once

#include <memory>
#include <string>
#include <vector>

#include "striate/config/diagnostics.hpp"
#include "striate/tasks/nodes/scope_node.hpp"
#include "striate/tasks/show/outline.hpp"

namespace striate::tasks {

/// What a mission is after: `goal` of the script.
enum class TaskGoal {
  steps,  ///< to do its steps
  line  ///< to cross the goal line of the world; whoever sees it crossed ends the task with success
};

/// A file that a task was read from.
struct TaskFile {
  std::string path;  ///< absolute
  /// Where the file that uses it looks for it first: the same path, unless it was found in a
  /// configuration (config/configuration_path.hpp). A copy that stands there is found again.
  std::string place;
  bool operator==(const TaskFile& other) const = default;
};

/// A task script, checked and ready to run once.
struct Task {
  std::string file;
  std::vector<TaskFile> files;  ///< that file and those it uses
  std::string mission;
  TaskGoal goal = TaskGoal::steps;
  std::vector<std::string> landmarks;  ///< what it needs to know: `needs: {landmarks: [book]}`
  std::vector<std::string> variables;  ///< names in `vars` and in `needs: {parameters: ...}`
  std::unique_ptr<ScopeNode> root;     ///< guards, steps and `finally`; never nullptr when usable
  Outline outline;                     ///< the same, to be shown
  /// What is still read but should be written otherwise: "file:line:column: note: ..."; for the
  /// caller to show.
  std::string notices;
};

}  // namespace striate::tasks
