#pragma once

#include <string>
#include <vector>

#include "striate/agent/plugins/plugin_contents.hpp"

namespace striate::agent {

/// Loads a shared object and asks what it adds; enrolls nothing. Its code runs with all rights of
/// this process, from here on.
/// @throws UserError, one sentence and how to mend it, where there is no such file, it cannot be
/// loaded, is no plugin, is built for another interface, or has a name that is taken
[[nodiscard]] Plugin load_plugin(const std::string& file);

/// Loads it and enrolls all that it adds, before the first task script is read. The same file
/// again does nothing. @throws UserError as load_plugin(); then nothing was enrolled
void use_plugin(const std::string& file);

/// Those that are in use, in the order in which they came, without what they added.
struct PluginInUse {
  std::string name;
  std::string file;
};
[[nodiscard]] const std::vector<PluginInUse>& plugins_in_use();

}  // namespace striate::agent
