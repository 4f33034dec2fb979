#include "striate/tasks/reader/step_reader.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "striate/behaviours/registry.hpp"
#include "striate/config/map_reader.hpp"
#include "striate/tasks/fault.hpp"
#include "striate/tasks/nodes/action_node.hpp"
#include "striate/tasks/nodes/repeat_node.hpp"
#include "striate/tasks/nodes/sequence_node.hpp"
#include "striate/tasks/nodes/together_node.hpp"
#include "striate/tasks/nodes/try_node.hpp"

namespace striate::tasks {
namespace {

using config::Node;

/// What a step can be besides an action.
const std::vector<std::string> kGroups = {"do", "try", "together", "repeat", "use"};
/// What can stand beside it.
const std::vector<std::string> kBeside = {"until",  "within",   "if_it_fails", "only_if",
                                          "unless", "optional", "with"};

bool is_one_of(const std::string& word, const std::vector<std::string>& words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

/// A group of several steps made of its children.
template <class Group>
Branch group(Outline::Kind kind, const Node::Entry& entry, Flow flow, std::vector<Branch> steps) {
  Branch branch;
  branch.flow = flow;
  Children children = take(std::move(steps));
  branch.outline.kind = kind;
  branch.outline.name = entry.key;
  branch.outline.children = std::move(children.outlines);
  branch.node = std::make_unique<Group>(std::move(children.nodes));
  return branch;
}

}  // namespace

bool is_word_of_steps(const std::string& word) {
  return is_one_of(word, kGroups) || is_one_of(word, kBeside);
}

std::vector<Branch> StepReader::list(const Node& node, const std::string& key) {
  std::vector<Branch> steps;
  if (node.kind != Node::Kind::list) {
    diagnostics_.add(fault::wrong_kind, node.place,
                     fmt::format("'{}' must be a list of steps, but is {}", key, node.describe()),
                     "begin each step with '- '");
    return steps;
  }
  if (node.items.empty()) {
    diagnostics_.add(fault::no_action, node.place, fmt::format("'{}' has no steps", key));
  }
  for (const Node& item : node.items) steps.push_back(step(item));
  return steps;
}

Branch StepReader::sequence(const Node& node, const std::string& key, bool keep_going) {
  std::vector<Branch> steps = list(node, key);
  check_sequence(steps, keep_going, diagnostics_);
  Branch branch;
  branch.flow = flow_of_sequence(steps);
  Children children = take(std::move(steps));
  branch.outline.kind = Outline::Kind::sequence;
  branch.outline.name = key;
  branch.outline.place = node.place;
  branch.outline.children = std::move(children.outlines);
  branch.node = std::make_unique<SequenceNode>(std::move(children.nodes), keep_going);
  branch.outline.node = branch.node.get();
  return branch;
}

Branch StepReader::step(const Node& node) {
  Branch branch;
  if (--context_.steps_left < 0) {
    if (context_.steps_left == -1) {
      diagnostics_.add(fault::too_large, node.place, "more than 5000 steps, with all that is used");
    }
    return branch;
  }
  if (node.kind != Node::Kind::map) {
    diagnostics_.add(fault::wrong_kind, node.place,
                     fmt::format("a step must be an action, but is {}", node.describe()),
                     "write '- stop: {}'");
    return branch;
  }
  branch = body(node);
  branch.outline.place = node.place;
  limit(node, branch);
  recover(node, branch);
  make_optional(node, branch);
  guard(node, branch);
  branch.outline.node = branch.node.get();
  return branch;
}

Branch StepReader::body(const Node& step) {
  const Node::Entry* first = nullptr;
  for (const Node::Entry& entry : step.entries) {
    if (is_one_of(entry.key, kBeside)) continue;
    if (!is_one_of(entry.key, kGroups) && behaviours::find_behaviour(entry.key) == nullptr) {
      unknown_action(entry);
      // It stands for the action that was meant, unless there is another.
      if (first == nullptr) first = &entry;
    } else if (first != nullptr &&
               (is_one_of(first->key, kGroups) || behaviours::find_behaviour(first->key))) {
      diagnostics_.add(
          fault::two_actions, entry.key_place,
          fmt::format("this step has two actions, '{}' and '{}'", first->key, entry.key),
          "begin the second with '- ' as a step of its own");
    } else {
      first = &entry;
    }
  }
  const Node::Entry* with = step.find("with");
  if (with != nullptr && step.find("use") == nullptr) {
    diagnostics_.add(fault::key_out_of_place, with->key_place,
                     "'with' is for a step with 'use' alone",
                     "parameters of an action stand in its own braces");
  }
  if (first == nullptr) {
    diagnostics_.add(fault::no_action, step.place, "this step has no action");
    return {};
  }
  return body_of(*first, step);
}

Branch StepReader::body_of(const Node::Entry& entry, const Node& step) {
  if (entry.key == "do") return sequence(entry.value, "do");
  if (entry.key == "try") return attempts(entry);
  if (entry.key == "together") return together(entry);
  if (entry.key == "repeat") return repeat(entry);
  if (entry.key == "use") return read_use(step, context_, diagnostics_);
  return action(entry);
}

Branch StepReader::action(const Node::Entry& entry) {
  Branch branch;
  branch.outline.name = entry.key;
  const behaviours::BehaviourEntry* found = behaviours::find_behaviour(entry.key);
  if (found == nullptr) return branch;
  const std::size_t before = diagnostics_.count();
  std::unique_ptr<behaviours::Behaviour> behaviour =
      found->make(entry.value, diagnostics_, context_.robot);
  branch.flow.motors = behaviour->motors();
  // Wrong parameters may be those that say when it ends.
  if (diagnostics_.count() == before) {
    branch.flow.succeeds = behaviour->ends_by_itself();
    branch.flow.fails = behaviour->can_fail();
  }
  const Node arguments = behaviours::detail::with_main(entry.value, found->main);
  for (const Node::Entry& argument : arguments.entries) {
    branch.outline.arguments.emplace_back(
        argument.key, argument.value.kind == Node::Kind::scalar ? argument.value.text : "...");
  }
  branch.node = std::make_unique<ActionNode>(entry.key, entry.key_place.line, std::move(behaviour));
  return branch;
}

void StepReader::unknown_action(const Node::Entry& entry) {
  std::vector<std::string> names = kBeside;
  names.insert(names.end(), kGroups.begin(), kGroups.end());
  for (const behaviours::BehaviourEntry& behaviour : behaviours::behaviour_registry())
    names.push_back(behaviour.name);
  std::string hint = config::suggest(entry.key, names);
  if (hint.empty()) hint = "'striate task actions' lists what there is";
  diagnostics_.add(fault::unknown_action, entry.key_place,
                   fmt::format("unknown action '{}'", entry.key), hint);
}

Branch StepReader::attempts(const Node::Entry& entry) {
  std::vector<Branch> steps = list(entry.value, entry.key);
  check_try(steps, diagnostics_);
  const Flow flow = flow_of_try(steps);
  return group<TryNode>(Outline::Kind::fallback, entry, flow, std::move(steps));
}

Branch StepReader::together(const Node::Entry& entry) {
  std::vector<Branch> steps = list(entry.value, entry.key);
  check_together(steps, diagnostics_);
  const Flow flow = flow_of_together(steps);
  return group<TogetherNode>(Outline::Kind::parallel, entry, flow, std::move(steps));
}

Branch StepReader::repeat(const Node::Entry& entry) {
  int times = 0;
  Branch round;
  const std::size_t before = diagnostics_.count();
  if (entry.value.kind == Node::Kind::scalar) {
    diagnostics_.add(fault::wrong_kind, entry.value.place,
                     fmt::format("'repeat' must be steps, but is '{}'", entry.value.text),
                     "write repeat: {times: 3, do: [...]}, or a list of steps to repeat for ever");
  } else if (entry.value.kind == Node::Kind::list) {
    round = sequence(entry.value, "repeat");
  } else {
    config::MapReader map(entry.value, "repeat", diagnostics_);
    map.integer("times", times, {1, 1000000});
    if (map.require("do")) round = sequence(*map.raw("do"), "do");
    map.finish();
  }
  Branch branch;
  branch.flow = round.flow;
  branch.flow.skips = false;
  branch.flow.succeeds =
      (times > 0 && round.flow.lets_next_begin()) || diagnostics_.count() != before;
  branch.outline = std::move(round.outline);
  branch.outline.kind = Outline::Kind::repeat;
  branch.outline.name = entry.key;
  branch.outline.times = times;
  if (round.node) branch.node = std::make_unique<RepeatNode>(std::move(round.node), times);
  return branch;
}

}  // namespace striate::tasks
