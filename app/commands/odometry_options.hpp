#pragma once

#include <CLI/CLI.hpp>

#include "striate/app/commands/sequence_options.hpp"
#include "striate/app/sequence_odometry.hpp"

namespace striate::app {

/// --rectified, --width-px, --features: what visual odometry is asked, by any command that runs it.
void add_odometry_options(CLI::App& command, SequenceOdometryOptions& given);

}  // namespace striate::app
