#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "striate/viewer/mcap/compression.hpp"

/// `--mcap FILE` and `--compression`, the same for each command that writes such a file.
namespace striate::app {

struct McapOptions {
  std::string file;  ///< "" for none
  std::string compression = "zstd";
};

/// @return the option `--mcap`
inline CLI::Option* add_mcap_options(CLI::App& command, McapOptions& options) {
  CLI::Option* mcap =
      command.add_option("--mcap", options.file,
                         "MCAP file of all that is felt, seen and decided, for Foxglove, "
                         "Lichtblick, Rerun and ROS 2");
  command.add_option("--compression", options.compression, "how the MCAP file is made smaller")
      ->check(CLI::IsMember({"zstd", "lz4", "none"}))
      ->needs(mcap)
      ->capture_default_str();
  return mcap;
}

[[nodiscard]] inline viewer::mcap::Compression compression_of(const McapOptions& options) {
  return viewer::mcap::compression_of(options.compression);
}

}  // namespace striate::app
