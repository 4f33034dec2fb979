#pragma once

#include <string>
#include <vector>

#include "striate/tasks/task_reader.hpp"

namespace striate::agent {

/// "way=20 m" as the variable `way` of a task. @throws UserError for what is none
[[nodiscard]] tasks::GivenVariables read_variables(const std::vector<std::string>& given);

/// A variable that the task does not have would change nothing.
/// @throws UserError that names the nearest of those that it has
void check_variables(const tasks::GivenVariables& given, const tasks::Task& task);

}  // namespace striate::agent
