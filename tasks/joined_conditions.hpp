#pragma once

#include <memory>
#include <string>
#include <vector>

#include "striate/tasks/condition.hpp"

namespace striate::tasks {

/// `all`, `any` and `not` join conditions; no condition may have such a name.
[[nodiscard]] bool joins_conditions(const std::string& word);

using Conditions = std::vector<std::unique_ptr<Condition>>;

/// Holds while all of them do. Each counts from the start of the step.
[[nodiscard]] std::unique_ptr<Condition> all_of(Conditions conditions);
/// Holds while any of them does.
[[nodiscard]] std::unique_ptr<Condition> any_of(Conditions conditions);
/// Holds while it does not.
[[nodiscard]] std::unique_ptr<Condition> not_of(std::unique_ptr<Condition> condition);

}  // namespace striate::tasks
