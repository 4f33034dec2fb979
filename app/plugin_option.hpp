#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <vector>

namespace striate::app {

/// `--plugin FILE`, as often as wanted. They are in use before the command's callback is called.
/// @return the files as they were given, known from then on
std::shared_ptr<const std::vector<std::string>> add_plugin_option(CLI::App& command);

}  // namespace striate::app
