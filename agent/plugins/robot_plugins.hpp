#pragma once

#include <string>
#include <vector>

#include "striate/config/diagnostics.hpp"
#include "striate/config/node.hpp"
#include "striate/config/settings.hpp"

namespace striate::agent {

/// What becomes of the line `plugins` in a robot's YAML.
enum class PluginLines {
  load,   ///< they are loaded, before the body is looked for among them
  ignore  ///< of a file that came with a recording: data never names the code that is to be run
};

/// The body that a robot's YAML names.
struct NamedBody {
  std::string name;  ///< "": none is named, or `pioneer`
  config::SourceLocation place;
  config::Node settings;  ///< of kind nothing: all defaults
};

/// Takes `plugins: [FILE, ...]` and `body: NAME` or `body: {NAME: {...}}` out of the robot's YAML,
/// so that the rest are settings. Loads the plugins, whose paths are relative to the file of the
/// diagnostics, and checks the body's settings.
[[nodiscard]] NamedBody take_plugins(config::Node& robot, config::Diagnostics& diagnostics,
                                     PluginLines lines);

/// What the body's settings are with that section; for `striate config`.
[[nodiscard]] std::vector<config::SettingLine> settings_of(const NamedBody& body);

}  // namespace striate::agent
