#pragma once

#include <CLI/CLI.hpp>

namespace striate::app {

/// From now on `app` and all commands below it refuse an empty name of a file or folder, which a
/// script gives where a variable of its own is not set: `--memory "$HOME_DB"`.
void refuse_empty_names(CLI::App& app);

}  // namespace striate::app
