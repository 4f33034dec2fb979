#include "striate/tasks/reader/script_reader.hpp"

#include <fmt/format.h>

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
