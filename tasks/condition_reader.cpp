#include "striate/tasks/condition_reader.hpp"

#include <fmt/format.h>

#include <utility>
#include <vector>

#include "striate/tasks/condition_registry.hpp"
#include "striate/tasks/fault.hpp"
#include "striate/tasks/joined_conditions.hpp"
#include "striate/tasks/landmark_conditions.hpp"

namespace striate::tasks {
namespace {

using config::Node;

std::unique_ptr<Condition> read_not(const Node::Entry& entry, config::Diagnostics& diagnostics) {
  if (entry.value.kind != Node::Kind::map) {
    diagnostics.add(fault::bad_condition, entry.value.place,
                    fmt::format("'not' must be a condition, but is {}", entry.value.describe()),
                    "write {not: {landmark_seen: book}}");
    return nullptr;
  }
  std::unique_ptr<Condition> condition = read_condition(entry.value, diagnostics);
  if (!condition) return nullptr;
  return not_of(std::move(condition));
}

std::unique_ptr<Condition> read_joined_conditions(const Node::Entry& entry,
                                                  config::Diagnostics& diagnostics) {
  if (entry.key == "not") return read_not(entry, diagnostics);
  const Node& list = entry.value;
  if (list.kind != Node::Kind::list || list.items.empty()) {
    diagnostics.add(
        fault::bad_condition, list.place,
        fmt::format("'{}' must be a list of conditions, but is {}", entry.key,
                    list.kind == Node::Kind::list ? "empty" : list.describe()),
        fmt::format("write {{{}: [{{travelled: 58 m}}, {{landmark_seen: book}}]}}", entry.key));
    return nullptr;
  }
  Conditions conditions;
  for (const Node& item : list.items) {
    if (auto condition = read_condition(item, diagnostics)) {
      conditions.push_back(std::move(condition));
    }
  }
  if (conditions.size() != list.items.size()) return nullptr;
  if (entry.key == "all") return all_of(std::move(conditions));
  return any_of(std::move(conditions));
}

std::string joined_text(const Node::Entry& entry) {
  if (entry.key == "not") return fmt::format("not: {{{}}}", condition_text(entry.value));
  std::string text;
  for (const Node& item : entry.value.items) {
    text += fmt::format("{}{}", text.empty() ? "" : ", ", condition_text(item));
  }
  return fmt::format("{}: [{}]", entry.key, text);
}

/// @param negated an odd number of `not` stand above it.
const Node::Entry* lasts(const Node& condition, bool negated) {
  const Node::Entry& entry = condition.entries.front();
  if (entry.key == "not") return lasts(entry.value, !negated);
  if (!joins_conditions(entry.key)) {
    const ConditionEntry* kind = find_condition(entry.key);
    if (kind == nullptr) return nullptr;
    const bool is_lasting = kind->standing == WhileStanding::stays ||
                            (kind->standing == WhileStanding::comes && !negated);
    return is_lasting ? &entry : nullptr;
  }
  // `not` turns all into any (De Morgan): all last only together, any of them alone.
  const bool all = (entry.key == "all") != negated;
  const Node::Entry* lasting = nullptr;
  for (const Node& item : entry.value.items) {
    const Node::Entry* found = lasts(item, negated);
    if (all && found == nullptr) return nullptr;
    if (lasting == nullptr) lasting = found;
  }
  return lasting;
}

}  // namespace

std::string condition_text(const config::Node& node) {
  if (node.kind != config::Node::Kind::map || node.entries.size() != 1) return {};
  if (joins_conditions(node.entries.front().key)) return joined_text(node.entries.front());
  const config::Node& value = node.entries.front().value;
  std::string text = value.text;
  for (const config::Node::Entry& part : value.entries) {
    text += fmt::format("{}{}", text.empty() ? "" : ", ", part.value.text);
  }
  return fmt::format("{}: {}", node.entries.front().key, text);
}

std::unique_ptr<Condition> read_condition(const config::Node& node,
                                          config::Diagnostics& diagnostics) {
  if (node.kind != config::Node::Kind::map || node.entries.size() != 1) {
    diagnostics.add(
        fault::bad_condition, node.place,
        fmt::format("a condition must be one 'name: value', but is {}", node.describe()),
        node.kind == config::Node::Kind::map && node.entries.size() > 1
            ? "join several: {all: [{travelled: 58 m}, {landmark_seen: book}]}, or 'any'"
            : "write {travelled: 58 m}");
    return nullptr;
  }
  const config::Node::Entry& entry = node.entries.front();
  if (joins_conditions(entry.key)) return read_joined_conditions(entry, diagnostics);
  if (entry.key == kOldImageOlderThan) {
    diagnostics.warn(entry.key_place, "'picture_older_than' is called 'image_older_than' now",
                     "write 'image_older_than'");
  }
  const ConditionEntry* found = find_condition(entry.key);
  if (found == nullptr) {
    std::vector<std::string> names = {"all", "any", "not"};
    for (const ConditionEntry& known : condition_registry()) names.push_back(known.name);
    std::string hint = config::suggest(entry.key, names);
    if (hint.empty()) hint = "'striate task actions' lists what there is";
    diagnostics.add(fault::unknown_condition, entry.key_place,
                    fmt::format("unknown condition '{}'", entry.key), hint);
    return nullptr;
  }
  if (found->make_of != nullptr) return read_landmark_condition(*found, entry, diagnostics);
  const auto value = config::read_quantity(entry.value, found->unit, found->range, diagnostics);
  return value ? found->make(*value) : nullptr;
}

const Node::Entry* lasts_while_standing(const Node& condition) {
  return lasts(condition, false);
}

}  // namespace striate::tasks
