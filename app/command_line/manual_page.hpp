#pragma once

#include <string>

#include "striate/app/command_line/command_text.hpp"

namespace striate::app {

/// The manual page striate(1) as roff with the `man` macros: all commands and options, exit codes,
/// environment, files and examples.
/// @param software its name and version: "striate 0.1.0"
[[nodiscard]] std::string manual_page(const CommandText& striate, const std::string& software);

}  // namespace striate::app
