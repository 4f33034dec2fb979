#pragma once

#include <filesystem>

#include "striate/app/doctor/finding.hpp"

namespace striate::app {

/// Every world, task and robot file below a folder of configuration. Each mistake is a finding.
/// @param folder with worlds/, tasks/ and robots/
[[nodiscard]] Findings look_at_configuration(const std::filesystem::path& folder);

/// The long-term memory in a file: does it open, and is it whole?
[[nodiscard]] Finding look_at_memory(const std::string& file);

}  // namespace striate::app
