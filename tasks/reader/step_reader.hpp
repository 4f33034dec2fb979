#pragma once

#include <string>
#include <vector>

#include "striate/config/diagnostics.hpp"
#include "striate/config/node.hpp"
#include "striate/platform/interface/robot.hpp"
#include "striate/tasks/reader/branch.hpp"
#include "striate/tasks/task.hpp"
#include "striate/tasks/task_reader.hpp"

namespace striate::tasks {

/// What is the same for a script and all that it uses.
struct ReadContext {
  explicit ReadContext(const RobotDescription& of_robot) : robot(of_robot) {}

  const RobotDescription& robot;
  const KnownLandmarks* landmarks = nullptr;
  bool parameters_stay_open = false;  ///< checked alone: a parameter fits every type
  std::vector<TaskFile> files;        ///< the one being read last, before it those that use it
  std::vector<TaskFile> read;         ///< every file that was read, each once
  int steps_left = 5000;              ///< of all files together
};

/// Whether the word means something in a step already, so that no action may have it as its name.
[[nodiscard]] bool is_word_of_steps(const std::string& word);

/// Reads the steps of one file.
class StepReader {
 public:
  StepReader(ReadContext& context, config::Diagnostics& diagnostics)
      : context_(context), diagnostics_(diagnostics) {}

  /// A list of steps as a sequence. `keep_going`: a failed one does not end it.
  Branch sequence(const config::Node& list, const std::string& key, bool keep_going = false);

 private:
  std::vector<Branch> list(const config::Node& node, const std::string& key);
  Branch step(const config::Node& node);
  /// The one thing that a step does: an action or a group; the first where there are several.
  Branch body(const config::Node& step);
  Branch body_of(const config::Node::Entry& entry, const config::Node& step);
  Branch action(const config::Node::Entry& entry);
  Branch repeat(const config::Node::Entry& entry);
  Branch attempts(const config::Node::Entry& entry);
  Branch together(const config::Node::Entry& entry);
  void unknown_action(const config::Node::Entry& entry);

  // What the keys beside it make of a step, from the inside out.
  void limit(const config::Node& step, Branch& branch);
  void recover(const config::Node& step, Branch& branch);
  void make_optional(const config::Node& step, Branch& branch);
  void guard(const config::Node& step, Branch& branch);

  ReadContext& context_;
  config::Diagnostics& diagnostics_;
};

/// A step `use: file` with its `with`: the other file read with these parameters.
Branch read_use(const config::Node& step, ReadContext& context, config::Diagnostics& diagnostics);

}  // namespace striate::tasks
