#pragma once

#include <filesystem>
#include <vector>

#include "striate/app/doctor/finding.hpp"
#include "striate/config/configuration_path.hpp"

namespace striate::app {

/// Every world, task and robot file below a folder of configuration. Each mistake is a finding.
/// @param folder with worlds/, tasks/ and robots/
[[nodiscard]] Findings look_at_configuration(const std::filesystem::path& folder);

/// The same for each folder in which names are looked for; kinds that a folder does not have are
/// passed over. A note where none of the folders is there.
[[nodiscard]] Findings look_at_configurations(
    const std::vector<config::ConfigurationFolder>& folders = config::configuration_folders());

/// The long-term memory in a file: does it open, and is it whole?
[[nodiscard]] Finding look_at_memory(const std::string& file);

}  // namespace striate::app
