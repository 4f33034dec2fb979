#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "striate/base/named_table.hpp"
#include "striate/config/settings.hpp"
#include "striate/platform/interface/robot.hpp"

namespace striate::agent {

/// One kind of body that the robot's YAML may name: `body: NAME`, or `body: {NAME: {...}}` with
/// settings of its own.
struct BodyEntry {
  std::string name;
  std::string help;  ///< one line
  /// Checks its settings and lists those in force; mistakes are added to the diagnostics. An absent
  /// node (of kind nothing) means all defaults.
  std::function<std::vector<config::SettingLine>(const config::Node& settings,
                                                 config::Diagnostics& diagnostics)>
      settings;
  /// Wakes it. Only called with settings that `settings` found nothing wrong with. @param described
  /// what the section `robot` says of its shape and limits, and `camera` of its camera.
  /// Throws UserError or std::runtime_error where it does not come up.
  std::function<std::unique_ptr<Robot>(const config::Node& settings,
                                       const RobotDescription& described)>
      make;
};

using BodyRegistry = NamedTable<BodyEntry>;

/// The bodies of plugins. One table of the whole process. Ours are not in it: which of them is
/// driven is what the commands say.
[[nodiscard]] const BodyRegistry& body_registry();

/// Takes in one more, before the first robot is read; for plugins alone
/// (agent/plugins/load_plugin.hpp). @return false where the name is taken
bool enroll(BodyEntry entry);

/// An entry for a body class that has `Settings`, a `visit()` for it found by its namespace, and
/// the constructor B(const Settings&, const RobotDescription&).
template <class B>
BodyEntry body_entry(const std::string& name, const std::string& help) {
  using Settings = typename B::Settings;
  const auto read = [name](const config::Node& node, config::Diagnostics& diagnostics) {
    Settings settings;
    config::SettingsReader reader(node, name, diagnostics);
    visit(reader, settings);
    reader.finish();
    return settings;
  };
  BodyEntry entry;
  entry.name = name;
  entry.help = help;
  entry.settings = [read](const config::Node& node, config::Diagnostics& diagnostics) {
    Settings settings = read(node, diagnostics);
    config::SettingsPrinter printer;
    visit(printer, settings);
    return printer.lines();
  };
  entry.make = [read](const config::Node& node,
                      const RobotDescription& described) -> std::unique_ptr<Robot> {
    config::Diagnostics unheard("");  // `settings` has told them
    return std::make_unique<B>(read(node, unheard), described);
  };
  return entry;
}

}  // namespace striate::agent
