#pragma once

#include <string>
#include <utility>
#include <vector>

#include "striate/config/diagnostics.hpp"

namespace striate::tasks {

class TaskNode;

/// A task as a person draws it: one outline a step, with what it says about itself. Made by the
/// reader beside the tree that runs; text, SVG and XML are drawn from it.
struct Outline {
  enum class Kind {
    task,
    always,
    guard,
    finally,
    action,
    sequence,
    fallback,
    parallel,
    repeat,
    use,
    recovery
  };
  using Argument = std::pair<std::string, std::string>;

  Kind kind = Kind::action;
  std::string name;                 ///< of the action, file or mission; of a guard: its kind
  std::vector<Argument> arguments;  ///< as written, variables replaced
  std::string only_if;              ///< "progress: 5 m"; empty: not given. So the next ones
  std::string unless;
  std::string until;
  std::string within;
  bool optional = false;
  int times = 0;  ///< of a repeat (0: for ever) and of a recovery
  config::SourceLocation place;
  std::vector<Outline> children;
  /// What runs it, as long as the task lives; nullptr: nothing runs by itself, as a guard.
  const TaskNode* node = nullptr;
};

/// The tree in lines of text, for a terminal.
[[nodiscard]] std::string text_tree(const Outline& task);
/// A image of the tree.
[[nodiscard]] std::string svg_tree(const Outline& task);
/// The tree for editors that read the XML of BehaviorTree.CPP 4, with a model of every node that
/// it does not know by itself.
[[nodiscard]] std::string xml_tree(const Outline& task);

/// What a node does, in a few words: "traverse_corridor speed: 0.4 m/s", "try", "repeat 3 times".
[[nodiscard]] std::string title_of(const Outline& node);
/// How it may end or be skipped: "until progress: 5 m, within 4 min"; empty where nothing is said.
[[nodiscard]] std::string limits_of(const Outline& node);

}  // namespace striate::tasks
