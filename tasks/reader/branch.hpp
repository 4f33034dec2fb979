#pragma once

#include <vector>

#include "striate/tasks/nodes/task_node.hpp"
#include "striate/tasks/show/outline.hpp"

namespace striate::tasks {

/// How a piece of a task may come out; what cannot come out makes what waits for it unreachable.
struct Flow {
  bool succeeds = true;
  bool fails = true;
  bool skips = false;
  behaviours::Motors motors = behaviours::Motors::nothing;

  /// What follows it in `do` can be reached.
  [[nodiscard]] bool lets_next_begin() const { return succeeds || skips; }
};

/// A piece of a task as the reader makes it: what runs, what is shown, how it may come out. The
/// node is nullptr where the piece has mistakes.
struct Branch {
  NodePtr node;
  Outline outline;
  Flow flow;
};

/// The children of a group, their nodes and outlines taken out.
struct Children {
  std::vector<NodePtr> nodes;
  std::vector<Outline> outlines;
};
[[nodiscard]] Children take(std::vector<Branch> branches);

[[nodiscard]] Flow flow_of_sequence(const std::vector<Branch>& steps);
[[nodiscard]] Flow flow_of_try(const std::vector<Branch>& steps);
[[nodiscard]] Flow flow_of_together(const std::vector<Branch>& steps);

/// Says which step of a sequence is never reached. `keep_going`: failures do not end it.
void check_sequence(const std::vector<Branch>& steps, bool keep_going,
                    config::Diagnostics& diagnostics);
/// The same for the alternatives of `try`.
void check_try(const std::vector<Branch>& steps, config::Diagnostics& diagnostics);
/// Says which branches of `together` want the same motors.
void check_together(const std::vector<Branch>& steps, config::Diagnostics& diagnostics);

}  // namespace striate::tasks
