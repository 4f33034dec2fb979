#pragma once

#include <map>
#include <string>
#include <vector>

#include "striate/config/diagnostics.hpp"
#include "striate/platform/interface/robot.hpp"
#include "striate/tasks/task.hpp"

namespace striate::tasks {

/// Values that replace those of variables which a script declares: {"way", "58 m"}.
using GivenVariables = std::map<std::string, std::string>;
/// Names of the landmarks that the memory holds.
using KnownLandmarks = std::vector<std::string>;

/// Reads and checks a task script and the files that it uses. All mistakes are told in one pass,
/// as `file:line:column: error[T014]: ...` (the numbers: config/fault.hpp, tasks/fault.hpp):
/// @throws UserError with the whole list; nothing has moved then.
/// @param landmarks what the memory holds; nullptr: unknown, so `needs: landmarks` is not checked.
Task load_task(const std::string& file, const RobotDescription& robot,
               const GivenVariables& given = {}, const KnownLandmarks* landmarks = nullptr);

/// The same for a file that is not to be run now: parameters that it needs may be missing. What it
/// returns is to be shown, not run. @throws UserError
Task check_task(const std::string& file, const RobotDescription& robot,
                const KnownLandmarks* landmarks = nullptr);

/// The same as load_task() from text; `mistakes` collects (give it the letter 'T'), the task is
/// usable only if there are none. Files that it uses are looked for beside `mistakes.file()`.
Task read_task(const std::string& text, config::Diagnostics& diagnostics,
               const RobotDescription& robot, const GivenVariables& given = {});

}  // namespace striate::tasks
