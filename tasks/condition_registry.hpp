#pragma once

#include <memory>
#include <string>

#include "striate/base/named_table.hpp"
#include "striate/config/diagnostics.hpp"
#include "striate/config/node.hpp"
#include "striate/tasks/condition.hpp"

namespace striate::tasks {

using ConditionRegistry = NamedTable<ConditionEntry>;

/// All conditions that scripts can name: ours, and after them those of plugins. One table of the
/// whole process.
[[nodiscard]] const ConditionRegistry& condition_registry();

/// Takes in one more, for the scripts that are read from then on: those of plugins
/// (agent/plugins/load_plugin.hpp), and of Python, which may add some while missions run in other
/// threads. @return false where the name is taken
bool enroll(ConditionEntry entry);

/// The condition of that name, which may be an old name of it; or nullptr.
[[nodiscard]] const ConditionEntry* find_condition(const std::string& name);

/// Reads `{name: value}`; nullptr with mistakes added where that fails.
std::unique_ptr<Condition> read_condition(const config::Node& node,
                                          config::Diagnostics& diagnostics);

/// "name: value" as written, for people; empty where the node is no condition.
[[nodiscard]] std::string condition_text(const config::Node& node);

}  // namespace striate::tasks
