#include "tasks/task_reader.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "behaviours/registry.hpp"
#include "config/map_reader.hpp"
#include "tasks/variables.hpp"

namespace striate {
namespace {

using config::Mistakes;
using config::Node;

constexpr config::Range kWithin_s{0.1, 86400.0};
const std::vector<std::string> kStepKeys = {"until", "within", "if_it_fails"};

class TaskReader {
 public:
  TaskReader(const RobotDescription& robot, const GivenVariables& given, Mistakes& mistakes)
      : robot_(robot), given_(given), mistakes_(mistakes) {}

  Task read(Node root) {
    Task task;
    task.file = mistakes_.file();
    if (root.kind != Node::Kind::map) {
      if (mistakes_.none()) mistakes_.add(root.place, "a task script must be a map of keys");
      return task;
    }
    replace_variables(root);
    config::MapReader map(root, "the task", mistakes_);
    int version = 1;
    if (map.require("striate")) map.integer("striate", version, {1, 1});
    map.text("mission", task.mission);
    map.raw("vars");
    if (map.require("do")) task.steps = read_steps(*map.raw("do"), "do");
    if (const Node* node = map.raw("finally")) task.finally = read_steps(*node, "finally");
    map.finish();
    return task;
  }

 private:
  void replace_variables(Node& root) {
    Variables variables;
    if (const Node::Entry* entry = root.find("vars")) {
      variables = read_variables(entry->value, mistakes_);
      for (const auto& [name, value] : given_) {
        if (const auto found = variables.find(name); found != variables.end()) {
          found->second.text = value;
        }
      }
    }
    for (Node::Entry& entry : root.entries) {
      if (entry.key != "vars") substitute(entry.value, variables, mistakes_);
    }
  }

  std::vector<Step> read_steps(const Node& node, const std::string& key) {
    std::vector<Step> steps;
    if (node.kind != Node::Kind::list) {
      mistakes_.add(node.place,
                    fmt::format("'{}' must be a list of steps, but is {}", key, node.describe()),
                    "begin each step with '- '");
      return steps;
    }
    if (node.items.empty()) mistakes_.add(node.place, fmt::format("'{}' has no steps", key));
    for (const Node& item : node.items) steps.push_back(read_step(item));
    return steps;
  }

  Step read_step(const Node& node) {
    Step step;
    step.place = node.place;
    if (node.kind != Node::Kind::map) {
      mistakes_.add(node.place, fmt::format("a step must be an action, but is {}", node.describe()),
                    "write '- stop: {}'");
      return step;
    }
    for (const Node::Entry& entry : node.entries) {
      if (std::find(kStepKeys.begin(), kStepKeys.end(), entry.key) != kStepKeys.end()) continue;
      read_action(entry, step);
    }
    if (step.action.empty()) mistakes_.add(node.place, "this step has no action");
    config::MapReader map(node, "a step", mistakes_);
    if (const Node* until = map.raw("until")) step.until = read_condition(*until, mistakes_);
    double within_s = 0.0;
    if (map.number("within", within_s, config::Unit::duration, kWithin_s)) {
      step.within = from_seconds(within_s);
    }
    if (const Node* recovery = map.raw("if_it_fails")) step.if_it_fails = read_recovery(*recovery);
    return step;
  }

  void read_action(const Node::Entry& entry, Step& step) {
    const auto& registry = behaviour_registry();
    const auto found = std::find_if(registry.begin(), registry.end(),
                                    [&](const auto& b) { return b.name == entry.key; });
    if (found == registry.end()) {
      std::vector<std::string> names = kStepKeys;
      for (const auto& behaviour : registry) names.push_back(behaviour.name);
      std::string hint = config::suggest(entry.key, names);
      if (hint.empty()) hint = fmt::format("known: {}", fmt::join(names, ", "));
      mistakes_.add(entry.key_place, fmt::format("unknown action '{}'", entry.key), hint);
      if (step.action.empty()) step.action = entry.key;
      return;
    }
    if (step.behaviour) {
      mistakes_.add(entry.key_place,
                    fmt::format("this step has two actions, '{}' and '{}'", step.action, entry.key),
                    "begin the second with '- ' as a step of its own");
      return;
    }
    step.action = entry.key;
    step.behaviour = found->make(entry.value, mistakes_, robot_);
  }

  std::unique_ptr<Recovery> read_recovery(const Node& node) {
    auto recovery = std::make_unique<Recovery>();
    config::MapReader map(node, "if_it_fails", mistakes_);
    map.integer("tries", recovery->tries, {1, 100});
    if (map.require("do")) recovery->steps = read_steps(*map.raw("do"), "do");
    map.finish();
    return recovery;
  }

  const RobotDescription& robot_;
  const GivenVariables& given_;
  Mistakes& mistakes_;
};

}  // namespace

Task read_task(const std::string& text, Mistakes& mistakes, const RobotDescription& robot,
               const GivenVariables& given) {
  return TaskReader(robot, given, mistakes).read(parse_yaml(text, mistakes));
}

Task load_task(const std::string& file, const RobotDescription& robot,
               const GivenVariables& given) {
  Mistakes mistakes(file);
  Task task = TaskReader(robot, given, mistakes).read(load_yaml(mistakes));
  mistakes.throw_if_any();
  return task;
}

}  // namespace striate
