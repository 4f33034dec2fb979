#include <fmt/format.h>

#include <algorithm>

#include "striate/tasks/condition_reader.hpp"
#include "striate/tasks/fault.hpp"
#include "striate/tasks/reader/script_reader.hpp"

namespace striate::tasks {
namespace {

using config::Node;

}  // namespace

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
  const Node::Entry* lasting = lasts_while_standing(condition);
  if (lasting == nullptr) return;
  diagnostics_.add(
      fault::pauses_for_ever, lasting->key_place,
      fmt::format("the pause would never end: '{}' lasts while the robot stands", lasting->key),
      "use 'fail_if', or pause on what ends by itself, as 'image_older_than'");
}

}  // namespace striate::tasks
