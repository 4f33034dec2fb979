#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "behaviours/behaviour.hpp"
#include "config/settings.hpp"
#include "platform/interface/robot.hpp"

namespace striate {

/// One behaviour that task scripts may name.
struct BehaviourEntry {
  std::string name;
  std::string help;  ///< one line
  /// Builds it from its arguments; an absent node (of kind nothing) means all defaults. Wrong
  /// arguments are added to the mistakes; the result is then not to be run, but never null.
  std::function<std::unique_ptr<Behaviour>(
      const config::Node& arguments, config::Mistakes& mistakes, const RobotDescription& robot)>
      make;
  /// Name, default, range and meaning of every argument.
  std::function<std::vector<config::SettingLine>()> parameters;
};

/// All behaviours, by name.
[[nodiscard]] const std::vector<BehaviourEntry>& behaviour_registry();

/// The entry of that name, or nullptr.
[[nodiscard]] const BehaviourEntry* find_behaviour(const std::string& name);

/// An entry for a behaviour class that has `Settings`, a `visit()` for it found by its namespace,
/// and the constructor B(const Settings&, const RobotDescription&).
template <class B>
BehaviourEntry behaviour_entry(const std::string& name, const std::string& help) {
  BehaviourEntry entry;
  entry.name = name;
  entry.help = help;
  entry.make = [name](const config::Node& arguments, config::Mistakes& mistakes,
                      const RobotDescription& robot) -> std::unique_ptr<Behaviour> {
    typename B::Settings settings;
    if (arguments.kind != config::Node::Kind::nothing) {
      config::SettingsReader reader(arguments, name, mistakes);
      visit(reader, settings);
      reader.finish();
    }
    return std::make_unique<B>(settings, robot);
  };
  entry.parameters = [] {
    typename B::Settings settings;
    config::SettingsPrinter printer;
    visit(printer, settings);
    return printer.lines();
  };
  return entry;
}

}  // namespace striate
