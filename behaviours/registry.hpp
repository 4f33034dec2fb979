#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "striate/base/named_table.hpp"
#include "striate/behaviours/control/behaviour.hpp"
#include "striate/config/settings.hpp"
#include "striate/platform/interface/robot.hpp"

namespace striate::behaviours {

/// One behaviour that task scripts may name.
struct BehaviourEntry {
  std::string name;
  std::string help;  ///< one line
  /// Builds it from its arguments; an absent node (of kind nothing) means all defaults. Wrong
  /// arguments are added to the mistakes; the result is then not to be run, but never null.
  std::function<std::unique_ptr<Behaviour>(const config::Node& arguments,
                                           config::Diagnostics& diagnostics,
                                           const RobotDescription& robot)>
      make;
  /// Name, default, range and meaning of every argument.
  std::function<std::vector<config::SettingLine>()> parameters;
  std::string main;                   ///< `- say: hello` is `- say: {text: hello}`; empty: none
  std::vector<std::string> required;  ///< parameters without which it makes no sense
};

using BehaviourRegistry = NamedTable<BehaviourEntry>;

/// All behaviours: ours, and after them those of plugins. One table of the whole process.
[[nodiscard]] const BehaviourRegistry& behaviour_registry();

/// Takes in one more, for the scripts that are read from then on: those of plugins
/// (agent/plugins/load_plugin.hpp), and of Python, which may add some while missions run in other
/// threads. @return false where the name is taken
bool enroll(BehaviourEntry entry);

/// The entry of that name, or nullptr.
[[nodiscard]] const BehaviourEntry* find_behaviour(const std::string& name);

namespace detail {

/// A class may name its main parameter: `static constexpr const char* kMain = "text";`
template <class B>
std::string main_of() {
  if constexpr (requires { B::kMain; }) return B::kMain;
  return {};
}

/// And those that must be given: `static constexpr const char* kRequired[] = {"text"};`
template <class B>
std::vector<std::string> required_of() {
  if constexpr (requires { B::kRequired; }) {
    return {std::begin(B::kRequired), std::end(B::kRequired)};
  }
  return {};
}

/// And defaults that depend on the robot: `static Settings defaults_for(const RobotDescription&)`.
template <class B>
typename B::Settings defaults_of(const RobotDescription& robot) {
  if constexpr (requires { B::defaults_for(robot); }) return B::defaults_for(robot);
  return {};
}

/// `- say: hello` as `- say: {text: hello}`; anything else as it is.
[[nodiscard]] config::Node with_main(const config::Node& arguments, const std::string& main);

}  // namespace detail

/// An entry for a behaviour class that has `Settings`, a `visit()` for it found by its namespace,
/// and the constructor B(const Settings&, const RobotDescription&).
template <class B>
BehaviourEntry behaviour_entry(const std::string& name, const std::string& help) {
  BehaviourEntry entry;
  entry.name = name;
  entry.help = help;
  entry.main = detail::main_of<B>();
  entry.required = detail::required_of<B>();
  entry.make = [name, main = entry.main, required = entry.required](
                   const config::Node& given, config::Diagnostics& diagnostics,
                   const RobotDescription& robot) -> std::unique_ptr<Behaviour> {
    typename B::Settings settings = detail::defaults_of<B>(robot);
    const config::Node arguments = detail::with_main(given, main);
    config::SettingsReader reader(arguments, name, diagnostics);
    visit(reader, settings);
    for (const std::string& key : required) reader.require(key);
    reader.finish();
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

}  // namespace striate::behaviours
