#pragma once

#include <vector>

#include "striate/tasks/condition.hpp"

namespace striate::tasks {

/// What can be asked of memory about landmarks; part of `condition_registry()`.
[[nodiscard]] const std::vector<ConditionEntry>& landmark_conditions();

/// Reads the value of such a condition: the landmark's name, or a map of it and a quantity.
std::unique_ptr<Condition> read_landmark_condition(const ConditionEntry& kind,
                                                   const config::Node::Entry& entry,
                                                   config::Diagnostics& diagnostics);

}  // namespace striate::tasks
