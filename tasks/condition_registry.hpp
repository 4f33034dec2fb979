#pragma once

#include <string>

#include "striate/base/named_table.hpp"
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

/// Read for one more version, as `image_older_than`.
inline constexpr const char* kOldImageOlderThan = "picture_older_than";

/// The condition of that name, which may be an old name of it; or nullptr.
[[nodiscard]] const ConditionEntry* find_condition(const std::string& name);

}  // namespace striate::tasks
