#pragma once

#include <filesystem>
#include <string>

#include "striate/agent/robot_settings.hpp"

/// Files by the names that the command line knows: "corridor", "config/worlds/short.yaml", a path.
namespace striate::python {

/// @throws UserError with every place that was looked at where there is none; "" stays ""
[[nodiscard]] std::string task_file(const std::filesystem::path& given);
[[nodiscard]] std::string world_file(const std::filesystem::path& given);
[[nodiscard]] std::string robot_file(const std::filesystem::path& given);

/// The settings of a robot's file, "" for the built-in ones. Loads the plugins that it names.
/// @throws UserError with all mistakes of the file
[[nodiscard]] agent::RobotSettings settings_of(const std::filesystem::path& robot);

/// Lets plugins, which are loaded from now on, find Striate's symbols in this module, as they find
/// them in the program.
void open_to_plugins();

}  // namespace striate::python
