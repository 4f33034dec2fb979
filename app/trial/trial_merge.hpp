#pragma once

#include <string>
#include <vector>

namespace striate::app {

/// Joins the parts of a trial that ran on several machines: reads `runs/*.json` of each folder,
/// writes `runs.csv` and `table.md` of all into `out` and prints the table.
/// @return 1 where runs are missing, which are named on standard error: interrupted or lost ones,
/// and those of the seeds between without a result. Else 0.
/// @throws UserError for a folder without runs, runs of different tasks or settings of the
/// emergency layer, and a run that stands in two folders with different results.
int merge_trials(const std::vector<std::string>& folders, const std::string& out);

}  // namespace striate::app
