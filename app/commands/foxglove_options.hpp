#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "striate/viewer/foxglove/foxglove_server.hpp"

/// `--foxglove [PORT]` and who may come there, the same for each command that shows a robot.
namespace striate::app {

struct FoxgloveOptions {
  CLI::Option* asked = nullptr;  ///< `--foxglove`
  std::string port;              ///< "" or "true": the viewers' own default
  viewer::foxglove::ServerOptions server;

  /// With the port in it.
  [[nodiscard]] viewer::foxglove::ServerOptions for_server() const;
  [[nodiscard]] bool wanted() const { return asked != nullptr && asked->count() > 0; }
};

/// @param may_drive whether there is something to drive. `options` must outlive the command.
void add_foxglove_options(CLI::App& command, FoxgloveOptions& options, bool may_drive);

}  // namespace striate::app
