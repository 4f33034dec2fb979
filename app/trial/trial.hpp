#pragma once

#include "striate/app/trial/trial_plan.hpp"

namespace striate::app {

/// Runs what is missing of a trial, writes `runs.csv` and `table.md` into `options.out`, prints
/// the table. A trial that was stopped goes on where it was; a folder with runs of another kind
/// is refused. Returns the exit code: 0 all runs done, 1 some could not be run, 130 interrupted.
/// @throws UserError for options that make no sense.
int run_trial(const TrialOptions& options);

}  // namespace striate::app
