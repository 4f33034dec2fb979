#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <string>

#include "striate/platform/served/robot_server.hpp"

namespace striate::app {

/// `striate sim WORLD --serve`: the simulated Pioneer for other programs.
struct ServeOptions {
  bool tcp = false;
  bool pty = false;
  std::string address = "127.0.0.1";
  int port = 8101;  ///< where clients look for the first robot; ARIA's convention
  std::string kind = "p3dx-sh";
  std::string laser = "hokuyo";
  served::LineFaults faults;
  served::DeviceFaults devices;
  std::string world;
  std::string robot;
  std::uint64_t seed = 1;             ///< any; the first run of a series
  const CLI::App* command = nullptr;  ///< that has these options
  /// @throws UserError where one of them was given, but nothing is served
  void check() const;
  [[nodiscard]] bool serves() const { return tcp || pty; }
};

void add_serve_options(CLI::App& command, ServeOptions& options);
/// Serves until Ctrl-C.
int serve(const ServeOptions& options);

}  // namespace striate::app
