#pragma once

#include <string>

/// What `striate eval` measures on a person's own data. Each prints a table and writes it as CSV
/// and as a plot into `out`; returns the exit code. Throws UserError where the folder holds nothing
/// of the kind that is asked for.
namespace striate::evaluation {

struct EvalOptions {
  std::string folder;  ///< of the data; `striate eval KIND --help` lists the layouts
  std::string out;     ///< folder for CSV and plot; made where it is missing
};

int evaluate_stereo(const EvalOptions& options);
int evaluate_patches(const EvalOptions& options);
int evaluate_keypoints(const EvalOptions& options);
int evaluate_saliency(const EvalOptions& options);
int evaluate_objects(const EvalOptions& options);

}  // namespace striate::evaluation
