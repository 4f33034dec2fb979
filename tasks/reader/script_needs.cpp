#include <fmt/format.h>

#include <algorithm>

#include "striate/tasks/condition_registry.hpp"
#include "striate/tasks/fault.hpp"
#include "striate/tasks/reader/script_reader.hpp"

namespace striate::tasks {
namespace {

using config::Node;

}  // namespace

Variables ScriptReader::variables_of(const Node& root) {
  Variables variables;
  if (const Node::Entry* entry = root.find("vars")) {
    variables = read_variables(entry->value, diagnostics_);
  }
  for (const auto& [name, variable] : variables) script_.task.variables.push_back(name);
  needed_parameters(root, variables);
  for (auto& [name, variable] : variables) {
    script_.parameters.push_back(name);
    if (const auto given = given_.find(name); given != given_.end()) variable = given->second;
  }
  return variables;
}

/// A parameter without a value of its own: given by `with`, or open while the file is checked
/// alone.
void ScriptReader::needed_parameters(const Node& root, Variables& variables) {
  const Node::Entry* needs = root.find("needs");
  const Node::Entry* list = needs == nullptr ? nullptr : needs->value.find("parameters");
  if (list == nullptr) return;
  for (const std::string& name : names(&list->value, "parameters")) {
    Variable& variable = variables[name];
    variable.value.kind = Node::Kind::scalar;
    variable.value.open = true;
    script_.task.variables.push_back(name);
    if (given_.find(name) != given_.end()) continue;
    script_.missing.push_back(name);
    const bool alone = context_.files.size() == 1;
    if (!alone || context_.parameters_stay_open) continue;
    diagnostics_.add(fault::missing_parameter, list->value.place,
                     fmt::format("the task needs the parameter '{}'", name),
                     "run the task that uses it, or give it a value in vars");
  }
}

std::vector<std::string> ScriptReader::names(const Node* node, const char* what) {
  std::vector<std::string> list;
  if (node == nullptr) return list;
  const bool good = node->kind == Node::Kind::list &&
                    std::all_of(node->items.begin(), node->items.end(),
                                [](const Node& item) { return item.kind == Node::Kind::scalar; });
  if (!good) {
    diagnostics_.add(fault::wrong_kind, node->place,
                     fmt::format("'{}' must be a list of names", what),
                     "write it like [book, door]");
    return list;
  }
  for (const Node& item : node->items) list.push_back(item.text);
  return list;
}

void ScriptReader::read_needs(const Node& node) {
  config::MapReader map(node, "needs", diagnostics_);
  map.raw("parameters");
  if (const Node* landmarks = map.raw("landmarks")) {
    script_.task.landmarks = names(landmarks, "landmarks");
    check_landmarks(*landmarks);
  }
  map.finish();
}

void ScriptReader::check_landmarks(const Node& list) {
  if (context_.landmarks == nullptr) return;
  const KnownLandmarks& known = *context_.landmarks;
  for (const Node& item : list.items) {
    if (item.open) continue;  // checked alone: whoever uses it says which
    if (std::find(known.begin(), known.end(), item.text) != known.end()) continue;
    std::string hint = config::suggest(item.text, known);
    if (hint.empty()) hint = "teach it first, and give the memory that knows it with --memory FILE";
    diagnostics_.add(fault::unknown_landmark, item.place,
                     fmt::format("the memory knows no landmark '{}'", item.text), hint);
  }
}

}  // namespace striate::tasks
