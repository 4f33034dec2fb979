#include "tasks/variables.hpp"

#include <fmt/format.h>

#include "config/quantity.hpp"

namespace striate {

Variables read_variables(const config::Node& node, config::Mistakes& mistakes) {
  Variables variables;
  if (node.kind != config::Node::Kind::map) {
    mistakes.add(node.place, fmt::format("vars must be a map, but is {}", node.describe()),
                 "write vars: {cruise: 0.4 m/s}");
    return variables;
  }
  for (const config::Node::Entry& entry : node.entries) {
    if (entry.value.kind != config::Node::Kind::scalar) {
      mistakes.add(entry.value.place,
                   fmt::format("the variable '{}' must be one value", entry.key));
    } else if (!entry.value.text.empty() && entry.value.text[0] == '$') {
      mistakes.add(entry.value.place, "a variable cannot be made of another one",
                   "write its value out");
    } else {
      variables[entry.key] = entry.value;
    }
  }
  return variables;
}

void substitute(config::Node& node, const Variables& variables, config::Mistakes& mistakes) {
  for (config::Node& item : node.items) substitute(item, variables, mistakes);
  for (config::Node::Entry& entry : node.entries) substitute(entry.value, variables, mistakes);
  if (node.kind != config::Node::Kind::scalar || node.quoted || node.text.size() < 2 ||
      node.text[0] != '$') {
    return;
  }
  const std::string name = node.text.substr(1);
  const auto found = variables.find(name);
  if (found == variables.end()) {
    std::vector<std::string> known;
    known.reserve(variables.size());
    for (const auto& [key, value] : variables) known.push_back(key);
    std::string hint = config::suggest(name, known);
    if (hint.empty()) hint = fmt::format("add it: vars: {{{}: ...}}", name);
    mistakes.add(node.place, fmt::format("unknown variable '${}'", name), hint);
    return;
  }
  node.text = found->second.text;
  node.quoted = found->second.quoted;
}

}  // namespace striate
