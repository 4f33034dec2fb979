#pragma once

#include <memory>
#include <string>
#include <vector>

#include "striate/config/diagnostics.hpp"
#include "striate/config/node.hpp"
#include "striate/tasks/condition.hpp"

namespace striate::tasks {

/// All conditions that scripts can name.
[[nodiscard]] const std::vector<ConditionEntry>& condition_registry();

/// Reads `{name: value}`; nullptr with mistakes added where that fails.
std::unique_ptr<Condition> read_condition(const config::Node& node,
                                          config::Diagnostics& diagnostics);

/// "name: value" as written, for people; empty where the node is no condition.
[[nodiscard]] std::string condition_text(const config::Node& node);

}  // namespace striate::tasks
