#pragma once

#include <CLI/CLI.hpp>

namespace striate::app {

/// `striate eval odometry`, below the command `eval`.
void add_eval_odometry(CLI::App& eval, int& exit_code);

}  // namespace striate::app
