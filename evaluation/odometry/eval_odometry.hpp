#pragma once

#include <optional>
#include <string>
#include <vector>

#include "striate/evaluation/odometry/camera_truth.hpp"
#include "striate/evaluation/odometry/odometry_scores.hpp"

namespace striate::evaluation {

struct OdometryOptions {
  PairingSettings pairing;
  bool scale = false;               ///< the estimate's scale is unknown (one camera)
  double over_s = 1.0;              ///< of the relative pose error; of poses without times: poses
  std::vector<double> lengths_m;    ///< of the stretches; empty: KITTI's, or tenths of a short way
  BodyFromSensor body_from_sensor;  ///< where the truth is of the body
};

/// Everything that is said of an estimate.
struct OdometryScores {
  PairedPoses poses;
  Alignment alignment;
  std::vector<double> absolute_m;  ///< one a pair
  ErrorFigures absolute;
  RelativeErrors relative;
  KittiErrors kitti;
  double way_m = 0.0;
  bool timed = true;
};

/// Rotations of the truth that are inverted are seen by the estimate, and taken as they should be.
/// @throws UserError where too few poses belong together
[[nodiscard]] OdometryScores score_odometry(const datasets::Trajectory& truth,
                                            const datasets::Trajectory& estimate,
                                            const OdometryOptions& options);

/// The table for a person, with what each figure is.
[[nodiscard]] std::string scores_text(const OdometryScores& scores, const OdometryOptions& options);
[[nodiscard]] std::string scores_json(const OdometryScores& scores, const OdometryOptions& options);

/// Into `out`: odometry.csv, errors.csv, kitti_lengths.csv, odometry_error.svg,
/// estimate_aligned.tum and truth_at_estimate.tum (times as in the estimate, shifted as asked).
void write_scores(const OdometryScores& scores, const OdometryOptions& options,
                  const std::string& out);

}  // namespace striate::evaluation
