#pragma once

#include <map>
#include <string>

#include "config/node.hpp"

namespace striate {

/// Variables of a script: `vars: {cruise: 0.4 m/s}`, used as `$cruise`.
using Variables = std::map<std::string, config::Node>;

/// Reads the `vars` map; values are scalars.
Variables read_variables(const config::Node& node, config::Mistakes& mistakes);

/// Replaces every `$name` in the tree by its value, keeping the place of use for messages.
void substitute(config::Node& node, const Variables& variables, config::Mistakes& mistakes);

}  // namespace striate
