#pragma once

#include <map>
#include <string>
#include <vector>

#include "striate/config/node.hpp"

namespace striate::tasks {

/// A variable of a script, `vars: {cruise: 0.4 m/s}`, or a parameter that it is used with.
struct Variable {
  config::Node value;
  std::string origin;  ///< for messages: "set in line 3"
};
using Variables = std::map<std::string, Variable>;

/// Where a variable was put in.
struct Substitution {
  config::SourceLocation place;
  std::string name;
};

/// Reads the `vars` map; values are scalars.
Variables read_variables(const config::Node& node, config::Diagnostics& diagnostics);

/// Replaces every `$name` in the tree by its value, keeping the place of use for messages; a note
/// says there where the value comes from. @returns every place that was replaced.
std::vector<Substitution> substitute(config::Node& node, const Variables& variables,
                                     config::Diagnostics& diagnostics);

}  // namespace striate::tasks
