#include "striate/tasks/reader/script_reader.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "striate/tasks/condition_registry.hpp"
#include "striate/tasks/fault.hpp"

namespace striate::tasks {
namespace {

using config::Node;

}  // namespace

Script ScriptReader::read(Node root) {
  Task& task = script_.task;
  task.file = diagnostics_.file();
  if (root.kind != Node::Kind::map) {
    if (diagnostics_.none()) {
      diagnostics_.add(fault::wrong_kind, root.place, "a task script must be a map of keys");
    }
    return std::move(script_);
  }
  const Variables variables = variables_of(root);
  for (Node::Entry& entry : root.entries) {
    if (entry.key == "vars") continue;
    if (entry.key != "needs") {
      put_in(variables, entry.value);
      continue;
    }
    // Of what is needed the landmarks may be variables; parameters are names of such.
    for (Node::Entry& needed : entry.value.entries) {
      if (needed.key == "landmarks") put_in(variables, needed.value);
    }
  }
  config::MapReader map(root, "the task", diagnostics_);
  int version = 1;
  if (map.require("striate")) map.integer("striate", version, {1, 1});
  map.text("mission", task.mission);
  read_goal(map);
  map.raw("vars");
  if (const Node* needs = map.raw("needs")) read_needs(*needs);
  const Node* always = map.raw("always");
  const Node* finally = map.raw("finally");
  if (map.require("do")) build(always, *map.raw("do"), finally);
  map.finish();
  return std::move(script_);
}

/// Until version 0.1 a task that declared the variable `way` had the goal line as its goal.
void ScriptReader::read_goal(config::MapReader& map) {
  static const std::vector<std::string> kGoals = {"steps", "line"};
  int goal = 0;
  const bool said = map.choice("goal", goal, kGoals);
  script_.task.goal = goal == 1 ? TaskGoal::line : TaskGoal::steps;
  const bool used_by_another = context_.files.size() > 1;
  if (said || map.raw("goal") != nullptr || used_by_another) return;
  const Node::Entry* vars = map.node().find("vars");
  const Node::Entry* way = vars == nullptr ? nullptr : vars->value.find("way");
  if (way == nullptr) return;
  script_.task.goal = TaskGoal::line;
  script_.task.notices += fmt::format(
      "{}:{}:{}: note: a variable 'way' no longer says that the mission ends at the goal line\n"
      "    write 'goal: line' above 'do' ('goal: steps' if it does not end there); until the next "
      "version it is read as 'goal: line'\n",
      diagnostics_.file(), way->key_place.line, way->key_place.column);
}

void ScriptReader::put_in(const Variables& variables, Node& node) {
  for (Substitution& done : substitute(node, variables, diagnostics_)) {
    script_.substitutions.push_back(std::move(done));
  }
}

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

std::vector<Guard> ScriptReader::read_always(const Node& node, Outline& outline) {
  std::vector<Guard> guards;
  if (node.kind != Node::Kind::list) {
    diagnostics_.add(fault::wrong_kind, node.place,
                     fmt::format("'always' must be a list of guards, but is {}", node.describe()),
                     "write '- fail_if: {battery_below: 20 %}'");
    return guards;
  }
  for (const Node& item : node.items) read_guard(item, guards, outline);
  return guards;
}

void ScriptReader::read_guard(const Node& node, std::vector<Guard>& guards, Outline& outline) {
  static const std::vector<std::string> kKinds = {"pause_if", "fail_if"};
  if (node.kind != Node::Kind::map || node.entries.size() != 1) {
    diagnostics_.add(
        fault::wrong_kind, node.place,
        fmt::format("a guard must be one 'pause_if' or 'fail_if', but is {}", node.describe()),
        "write '- fail_if: {battery_below: 20 %}'");
    return;
  }
  const Node::Entry& entry = node.entries.front();
  if (std::find(kKinds.begin(), kKinds.end(), entry.key) == kKinds.end()) {
    std::string hint = config::suggest(entry.key, kKinds);
    if (hint.empty()) hint = "known: pause_if, fail_if";
    diagnostics_.add(fault::unknown_key, entry.key_place,
                     fmt::format("unknown guard '{}'", entry.key), hint);
    return;
  }
  Guard guard;
  guard.kind = entry.key == kKinds[0] ? Guard::Kind::pause_if : Guard::Kind::fail_if;
  guard.line = node.place.line;
  guard.text = condition_text(entry.value);
  guard.condition = read_condition(entry.value, diagnostics_);
  if (guard.kind == Guard::Kind::pause_if && guard.condition) check_pause(entry.value);
  Outline shown;
  shown.kind = Outline::Kind::guard;
  shown.name = entry.key;
  shown.until = guard.text;
  shown.place = node.place;
  outline.children.push_back(std::move(shown));
  if (guard.condition) guards.push_back(std::move(guard));
}

/// The robot stands while a task pauses, so what only its motion could end lasts for ever.
void ScriptReader::check_pause(const Node& condition) {
  const Node::Entry& entry = condition.entries.front();
  const ConditionEntry* kind = find_condition(entry.key);
  if (kind == nullptr || !kind->lasts_while_standing) return;
  diagnostics_.add(
      fault::pauses_for_ever, entry.key_place,
      fmt::format("the pause would never end: '{}' lasts while the robot stands", entry.key),
      "use 'fail_if', or pause on what ends by itself, as 'image_older_than'");
}

void ScriptReader::build(const Node* always, const Node& steps, const Node* finally) {
  Outline& outline = script_.task.outline;
  outline.kind = Outline::Kind::task;
  outline.name = script_.task.mission.empty() ? script_.task.file : script_.task.mission;
  if (script_.task.goal == TaskGoal::line) outline.until = "the goal line";
  std::vector<Guard> guards;
  if (always != nullptr) {
    Outline shown;
    shown.kind = Outline::Kind::always;
    shown.name = "always";
    guards = read_always(*always, shown);
    outline.children.push_back(std::move(shown));
  }
  StepReader reader(context_, diagnostics_);
  Branch doing = reader.sequence(steps, "do");
  Branch ending;
  script_.flow = doing.flow;
  outline.children.push_back(std::move(doing.outline));
  if (finally != nullptr) {
    ending = reader.sequence(*finally, "finally", true);
    ending.outline.kind = Outline::Kind::finally;
    script_.flow.motors = script_.flow.motors | ending.flow.motors;
    outline.children.push_back(std::move(ending.outline));
  }
  script_.flow.fails = script_.flow.fails || !guards.empty();
  script_.task.root =
      std::make_unique<ScopeNode>(std::move(guards), std::move(doing.node), std::move(ending.node));
}

}  // namespace striate::tasks
