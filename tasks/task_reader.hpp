#pragma once

#include <string>

#include "config/mistakes.hpp"
#include "platform/interface/robot.hpp"
#include "tasks/task.hpp"

namespace striate {

/// Reads and checks a task script: unknown or duplicate keys, actions, conditions and variables,
/// wrong types and units, missing parts. All mistakes are told in one pass:
/// @throws UserError with the whole list; nothing has moved then.
Task load_task(const std::string& file, const RobotDescription& robot);

/// The same from text; `mistakes` collects, the task is usable only if there are none.
Task read_task(const std::string& text, config::Mistakes& mistakes, const RobotDescription& robot);

}  // namespace striate
