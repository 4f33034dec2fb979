#pragma once

#include <map>
#include <string>

#include "config/mistakes.hpp"
#include "platform/interface/robot.hpp"
#include "tasks/task.hpp"

namespace striate {

using GivenVariables = std::map<std::string, std::string>;

/// Reads and checks a task script: unknown or duplicate keys, actions, conditions and variables,
/// wrong types and units, missing parts. All mistakes are told in one pass:
/// @throws UserError with the whole list; nothing has moved then.
/// @param given values that replace those of variables which the script declares: {"way", "58 m"}.
Task load_task(const std::string& file, const RobotDescription& robot,
               const GivenVariables& given = {});

/// The same from text; `mistakes` collects, the task is usable only if there are none.
Task read_task(const std::string& text, config::Mistakes& mistakes, const RobotDescription& robot,
               const GivenVariables& given = {});

}  // namespace striate
