#include <fmt/format.h>

#include "striate/config/map_reader.hpp"
#include "striate/tasks/condition_reader.hpp"
#include "striate/tasks/fault.hpp"
#include "striate/tasks/nodes/limited_node.hpp"
#include "striate/tasks/nodes/only_if_node.hpp"
#include "striate/tasks/nodes/optional_node.hpp"
#include "striate/tasks/nodes/recover_node.hpp"
#include "striate/tasks/reader/step_reader.hpp"

/// What the keys beside an action make of its step: until, within, if_it_fails, optional, only_if,
/// unless. Each puts a node round the branch.
namespace striate::tasks {
namespace {

using config::Node;

constexpr config::Range kWithin_s{0.1, 86400.0};  // seconds: from one cycle to a day

const Node* value_of(const Node& step, const char* key) {
  const Node::Entry* entry = step.find(key);
  return entry == nullptr ? nullptr : &entry->value;
}

/// `until: {after: 20 s}` with `within: 10 s` is never reached, nor is what holds with it alone.
void check_order(const Node& until, double within_s, config::Diagnostics& diagnostics) {
  if (until.kind != Node::Kind::map || until.entries.size() != 1) return;
  if (until.entries.front().key == "all") {
    for (const Node& joined : until.entries.front().value.items) {
      check_order(joined, within_s, diagnostics);
    }
  }
  if (until.entries.front().key != "after") return;
  config::Diagnostics unheard(diagnostics.file());
  const auto after_s = config::read_quantity(until.entries.front().value, config::Unit::duration,
                                             {0.0, 86400.0}, unheard);
  if (!after_s || *after_s <= within_s) return;
  diagnostics.add(fault::unreachable, until.entries.front().key_place,
                  "this is never reached: 'within' is over before", "make 'within' longer");
}

}  // namespace

void StepReader::limit(const Node& step, Branch& branch) {
  Limits limits;
  const Node* until = value_of(step, "until");
  if (until != nullptr) {
    limits.until = read_condition(*until, diagnostics_);
    branch.outline.until = condition_text(*until);
    branch.flow.succeeds = true;
  }
  if (const Node* within = value_of(step, "within")) {
    const auto within_s =
        config::read_quantity(*within, config::Unit::duration, kWithin_s, diagnostics_);
    if (within_s) limits.within = from_seconds(*within_s);
    if (within_s && until != nullptr) check_order(*until, *within_s, diagnostics_);
    branch.outline.within = within->text;
    branch.flow.fails = true;
  }
  if (!branch.node || (!limits.until && !limits.within)) return;
  branch.node = std::make_unique<LimitedNode>(branch.outline.name, step.place.line,
                                              std::move(branch.node), std::move(limits));
}

void StepReader::recover(const Node& step, Branch& branch) {
  const Node::Entry* entry = step.find("if_it_fails");
  if (entry == nullptr) return;
  int tries = 1;
  Branch recovery;
  config::MapReader map(entry->value, "if_it_fails", diagnostics_);
  map.integer("tries", tries, {1, 100});
  if (map.require("do")) recovery = sequence(*map.raw("do"), "do", true);
  map.finish();
  if (!branch.flow.fails) {
    diagnostics_.add(fault::unreachable, entry->key_place,
                     fmt::format("this is never reached: {} never fails", branch.outline.name),
                     "leave it away, or give the step a 'within:'");
  }
  recovery.outline.kind = Outline::Kind::recovery;
  recovery.outline.name = entry->key;
  recovery.outline.times = tries;
  recovery.outline.place = entry->key_place;
  branch.outline.children.push_back(std::move(recovery.outline));
  branch.flow.motors = branch.flow.motors | recovery.flow.motors;
  if (!branch.node || !recovery.node) return;
  branch.node =
      std::make_unique<RecoverNode>(std::move(branch.node), std::move(recovery.node), tries);
}

void StepReader::make_optional(const Node& step, Branch& branch) {
  config::MapReader map(step, "a step", diagnostics_);
  bool optional = false;
  if (!map.flag("optional", optional) || !optional) return;
  branch.outline.optional = true;
  branch.flow.succeeds = branch.flow.succeeds || branch.flow.fails;
  branch.flow.fails = false;
  if (branch.node) branch.node = std::make_unique<OptionalNode>(std::move(branch.node));
}

void StepReader::guard(const Node& step, Branch& branch) {
  const Node* only_if = value_of(step, "only_if");
  const Node* unless = value_of(step, "unless");
  if (only_if == nullptr && unless == nullptr) return;
  std::unique_ptr<Condition> wanted;
  std::unique_ptr<Condition> unwanted;
  if (only_if != nullptr) {
    wanted = read_condition(*only_if, diagnostics_);
    branch.outline.only_if = condition_text(*only_if);
  }
  if (unless != nullptr) {
    unwanted = read_condition(*unless, diagnostics_);
    branch.outline.unless = condition_text(*unless);
  }
  branch.flow.skips = true;
  if (!branch.node) return;
  branch.node =
      std::make_unique<OnlyIfNode>(std::move(branch.node), std::move(wanted), std::move(unwanted));
}

}  // namespace striate::tasks
