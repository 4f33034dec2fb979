#pragma once

#include <memory>
#include <string>
#include <vector>

#include "config/mistakes.hpp"
#include "tasks/nodes/scope_node.hpp"
#include "tasks/show/outline.hpp"

namespace striate {

/// A task script, checked and ready to run once.
struct Task {
  std::string file;
  std::vector<std::string> files;  ///< that file and those it uses; absolute paths
  std::string mission;
  std::vector<std::string> landmarks;  ///< what it needs to know: `needs: {landmarks: [book]}`
  std::vector<std::string> variables;  ///< names in `vars` and in `needs: {parameters: ...}`
  std::unique_ptr<ScopeNode> root;     ///< guards, steps and `finally`; never nullptr when usable
  Outline outline;                     ///< the same, to be shown
};

}  // namespace striate
