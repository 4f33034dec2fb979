#include "striate/tasks/reader/variables.hpp"

#include <fmt/format.h>

#include "striate/config/quantity.hpp"
#include "striate/tasks/fault.hpp"

namespace striate::tasks {
namespace {

using config::Node;

class Substituter {
 public:
  Substituter(const Variables& variables, config::Diagnostics& diagnostics)
      : variables_(variables), diagnostics_(diagnostics) {}

  void replace(Node& node) {
    for (Node& item : node.items) replace(item);
    for (Node::Entry& entry : node.entries) replace(entry.value);
    if (node.kind == Node::Kind::scalar && !node.quoted && node.text.size() > 1 &&
        node.text[0] == '$') {
      replace_scalar(node);
    }
  }

  std::vector<Substitution> done;

 private:
  void replace_scalar(Node& node) {
    const std::string name = node.text.substr(1);
    const auto found = variables_.find(name);
    if (found == variables_.end()) return say_unknown(node, name);
    const Node& value = found->second.value;
    if (!value.open) {
      node.text = value.text;
      node.quoted = value.quoted;
      diagnostics_.note(node.place,
                        fmt::format("${} is '{}', {}", name, value.text, found->second.origin));
    }
    node.open = value.open;
    done.push_back({node.place, name});
  }

  void say_unknown(Node& node, const std::string& name) {
    node.open = true;  // it is one mistake, not also one of its type
    std::vector<std::string> known;
    known.reserve(variables_.size());
    for (const auto& [key, value] : variables_) known.push_back(key);
    std::string hint = config::suggest(name, known);
    if (hint.empty()) hint = fmt::format("add it: vars: {{{}: ...}}", name);
    diagnostics_.add(fault::unknown_variable, node.place,
                     fmt::format("unknown variable '${}'", name), hint);
  }

  const Variables& variables_;
  config::Diagnostics& diagnostics_;
};

}  // namespace

Variables read_variables(const Node& node, config::Diagnostics& diagnostics) {
  Variables variables;
  if (node.kind != Node::Kind::map) {
    diagnostics.add(fault::wrong_kind, node.place,
                    fmt::format("vars must be a map, but is {}", node.describe()),
                    "write vars: {cruise: 0.4 m/s}");
    return variables;
  }
  for (const Node::Entry& entry : node.entries) {
    // Declared even where its value is wrong, so that its uses are not told as unknown.
    Variable& variable = variables[entry.key];
    variable.value = entry.value;
    variable.origin = fmt::format("set in line {}", entry.value.place.line);
    if (entry.value.kind != Node::Kind::scalar) {
      diagnostics.add(fault::bad_variable, entry.value.place,
                      fmt::format("the variable '{}' must be one value, but is {}", entry.key,
                                  entry.value.describe()));
      variable.value.open = true;
    } else if (!entry.value.text.empty() && entry.value.text[0] == '$') {
      diagnostics.add(fault::bad_variable, entry.value.place,
                      "a variable cannot be made of another one", "write its value out");
      variable.value.open = true;
    }
  }
  return variables;
}

std::vector<Substitution> substitute(Node& node, const Variables& variables,
                                     config::Diagnostics& diagnostics) {
  Substituter substituter(variables, diagnostics);
  substituter.replace(node);
  return std::move(substituter.done);
}

}  // namespace striate::tasks
