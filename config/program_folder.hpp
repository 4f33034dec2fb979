#pragma once

#include <filesystem>

namespace striate::config {

/// Beside what the shipped configuration is looked for (configuration_path.hpp): the folder of the
/// running program, unless another is set.
[[nodiscard]] std::filesystem::path program_folder();

/// For a library within another program, such as Python. Before the first file is looked for.
void set_program_folder(const std::filesystem::path& folder);

}  // namespace striate::config
