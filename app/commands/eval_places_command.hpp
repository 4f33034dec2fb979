#pragma once

#include <CLI/CLI.hpp>

namespace striate::app {

/// `striate eval places`, below the command `eval`.
void add_eval_places(CLI::App& eval, int& exit_code);

}  // namespace striate::app
