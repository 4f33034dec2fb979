#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "striate/agent/robot_settings.hpp"
#include "striate/config/configuration_path.hpp"

/// The verbs of `striate memory`, a file a group.
namespace striate::app {

/// What all verbs share.
struct MemoryCommandOptions {
  std::string file = "home.db";
  std::string robot;  ///< settings file; empty: the defaults
  bool json = false;

  /// @throws UserError with all mistakes of the settings file.
  [[nodiscard]] memory::LongTermSettings settings() const {
    return agent::load_robot_settings(config::find_configuration(robot, config::FileKind::robot))
        .long_term_memory;
  }
};

using SharedMemoryOptions = std::shared_ptr<MemoryCommandOptions>;

/// list, show, why
void add_memory_look_verbs(CLI::App& command, const SharedMemoryOptions& shared, int& exit_code);
/// map, episodes
void add_memory_map_verbs(CLI::App& command, const SharedMemoryOptions& shared, int& exit_code);
/// forget, restore, prune
void add_memory_change_verbs(CLI::App& command, const SharedMemoryOptions& shared, int& exit_code);
/// check, diff, export, import, merge
void add_memory_file_verbs(CLI::App& command, const SharedMemoryOptions& shared, int& exit_code);

}  // namespace striate::app
