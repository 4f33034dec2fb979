#include "striate/agent/plugins/plugin_contents.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "striate/base/entry_name.hpp"
#include "striate/base/user_error.hpp"
#include "striate/tasks/condition_registry.hpp"
#include "striate/tasks/reader/step_reader.hpp"

namespace striate::agent {
namespace {

template <class Entry>
bool has(const std::vector<Entry>& entries, const std::string& name) {
  return std::any_of(entries.begin(), entries.end(),
                     [&](const Entry& entry) { return entry.name == name; });
}

}  // namespace

void PluginContents::refuse(const std::string& what, const std::string& hint) const {
  throw UserError(
      fmt::format("{}: the plugin '{}' {}\n  hint: {}", plugin_.file, plugin_.name, what, hint));
}

void PluginContents::check_name(const std::string& kind, const std::string& name,
                                bool taken) const {
  if (!is_entry_name(name)) {
    refuse(fmt::format("has a {} with the name '{}', which is none", kind, name), kEntryNameRule);
  }
  if (taken) {
    refuse(fmt::format("has a {} '{}', and that name is taken", kind, name),
           "give it another name in the plugin, and build it again");
  }
}

void PluginContents::check_whole(const std::string& kind, const std::string& name,
                                 bool whole) const {
  if (whole) return;
  refuse(fmt::format("has a {} '{}' without what makes it", kind, name),
         fmt::format("fill all fields of its entry; see docs/plugins.md"));
}

void PluginContents::add(behaviours::BehaviourEntry entry) {
  check_name("behaviour", entry.name,
             has(plugin_.behaviours, entry.name) || tasks::is_word_of_steps(entry.name) ||
                 behaviours::find_behaviour(entry.name) != nullptr);
  check_whole("behaviour", entry.name, entry.make && entry.parameters);
  plugin_.behaviours.push_back(std::move(entry));
}

void PluginContents::add(tasks::ConditionEntry entry) {
  check_name("condition", entry.name,
             has(plugin_.conditions, entry.name) || tasks::find_condition(entry.name) != nullptr);
  check_whole("condition", entry.name, (entry.make == nullptr) != (entry.make_of == nullptr));
  plugin_.conditions.push_back(std::move(entry));
}

void PluginContents::add(perception::StageEntry entry) {
  check_name(
      "stage", entry.name,
      has(plugin_.stages, entry.name) || perception::stage_registry().find(entry.name) != nullptr);
  for (const std::string& figure : entry.figures) {
    check_name(fmt::format("stage '{}' with the figure", entry.name), figure,
               std::count(entry.figures.begin(), entry.figures.end(), figure) > 1);
  }
  check_whole("stage", entry.name, static_cast<bool>(entry.make));
  plugin_.stages.push_back(std::move(entry));
}

void PluginContents::add(BodyEntry entry) {
  check_name("body", entry.name,
             has(plugin_.bodies, entry.name) || entry.name == "pioneer" ||
                 body_registry().find(entry.name) != nullptr);
  check_whole("body", entry.name, entry.make && entry.settings);
  plugin_.bodies.push_back(std::move(entry));
}

}  // namespace striate::agent
