#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "striate/viewer/foxglove/foxglove_server.hpp"

/// `--foxglove [PORT]`, `--view [PORT]` and who may come there, the same for each command that
/// shows a robot.
namespace striate::app {

struct FoxgloveOptions {
  /// The port of the dashboard where none is given; by hand: beside Foxglove's own 8765
  static constexpr std::uint16_t kViewPort = 8780;

  CLI::Option* asked = nullptr;       ///< `--foxglove`
  CLI::Option* asked_view = nullptr;  ///< `--view`
  std::string port;                   ///< "" or "true": the viewers' own default
  std::string view_port;              ///< likewise: kViewPort
  viewer::foxglove::ServerOptions server;

  /// With the port in it, and an empty site where the dashboard is wanted. Both share one port:
  /// the dashboard's, unless only Foxglove's was given.
  [[nodiscard]] viewer::foxglove::ServerOptions for_server() const;
  [[nodiscard]] bool wants_foxglove() const { return asked != nullptr && asked->count() > 0; }
  [[nodiscard]] bool wants_view() const { return asked_view != nullptr && asked_view->count() > 0; }
  [[nodiscard]] bool wanted() const { return wants_foxglove() || wants_view(); }
  /// The addresses to open, a line each.
  [[nodiscard]] std::string addresses(const std::string& url, const std::string& page_url) const;
};

/// @param may_drive whether there is something to drive. `options` must outlive the command.
void add_foxglove_options(CLI::App& command, FoxgloveOptions& options, bool may_drive);

}  // namespace striate::app
