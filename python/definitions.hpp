#pragma once

#include <pybind11/pybind11.h>

#include <string>
#include <vector>

#include "striate/behaviours/control/behaviour.hpp"
#include "striate/config/quantity.hpp"

/// What Python adds to the language of task scripts. A definition stays until the process ends, as
/// a plugin does, and with it the Python objects: the tables outlive the interpreter.
namespace striate::python {

namespace py = pybind11;

/// One argument of an action.
struct ArgumentDefinition {
  enum class Kind { number, integer, flag, text, choice };
  std::string name;
  Kind kind = Kind::number;
  double number = 0.0;  ///< defaults, by kind
  int integer = 0;      ///< of a choice: which
  bool flag = false;
  std::string text;
  std::vector<std::string> choices;
  config::Unit unit = config::Unit::none;
  config::Range range;
  std::string help;
};

struct BehaviourDefinition {
  std::string name;
  std::string help;
  py::object make;  ///< called with a dict of arguments and the robot
  std::vector<ArgumentDefinition> arguments;
  std::string main;
  std::vector<std::string> required;
  behaviours::Motors motors = behaviours::Motors::both;
  bool ends_by_itself = true;
  bool can_fail = true;
};

struct ConditionDefinition {
  std::string name;
  std::string help;
  py::object make;  ///< called with the limit
  config::Unit unit = config::Unit::none;
  config::Range range;
  std::string example;
};

/// Makes it known to task scripts, or puts it in the place of Python's own of that name, which runs
/// in missions that are made from now on.
/// @throws UserError for a name that is none, or that others have
void define(BehaviourDefinition definition);
void define(ConditionDefinition definition);

}  // namespace striate::python
