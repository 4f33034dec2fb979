#pragma once

#include <map>
#include <string>
#include <vector>

#include "striate/config/map_reader.hpp"
#include "striate/tasks/reader/step_reader.hpp"
#include "striate/tasks/reader/variables.hpp"

namespace striate::tasks {

/// One file as it was read.
struct Script {
  Task task;
  Flow flow;
  std::vector<Substitution> substitutions;
  std::vector<std::string> parameters;  ///< names that `with` may set: vars, needs.parameters
  std::vector<std::string> missing;     ///< needed parameters that were not given
};

/// Reads one file: goal, vars, needs, always, do, finally.
class ScriptReader {
 public:
  /// @param given values of parameters and variables.
  ScriptReader(ReadContext& context, const Variables& given, config::Diagnostics& diagnostics)
      : context_(context), given_(given), diagnostics_(diagnostics) {}

  Script read(config::Node root);

 private:
  /// What `$name` may stand for in this file.
  Variables variables_of(const config::Node& root);
  void put_in(const Variables& variables, config::Node& node);
  void needed_parameters(const config::Node& root, Variables& variables);
  void read_goal(config::MapReader& map);
  void read_needs(const config::Node& node);
  std::vector<std::string> names(const config::Node* node, const char* what);
  void check_landmarks(const config::Node& list);
  std::vector<Guard> read_always(const config::Node& node, Outline& outline);
  void read_guard(const config::Node& node, std::vector<Guard>& guards, Outline& outline);
  void check_pause(const config::Node& condition);
  void build(const config::Node* always, const config::Node& steps, const config::Node* finally);

  ReadContext& context_;
  const Variables& given_;
  config::Diagnostics& diagnostics_;
  Script script_;
};

}  // namespace striate::tasks
