#pragma once

#include <string>
#include <vector>

#include "striate/config/configuration_path.hpp"

namespace striate::app {

/// What `striate config --paths` prints: the folders in the order in which they are searched, the
/// files that a bare name finds, and those that no name finds since another one goes before.
[[nodiscard]] std::string configuration_report(
    const std::vector<config::ConfigurationFolder>& folders = config::configuration_folders());

}  // namespace striate::app
