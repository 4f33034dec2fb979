#pragma once

#include <string>
#include <vector>

#include "striate/platform/datasets/trajectories/trajectory.hpp"

namespace striate::evaluation {

/// Where something was, and where it was thought to be, at one time.
struct PosePair {
  datasets::TimedPose truth;  ///< interpolated to the estimate's time
  datasets::TimedPose estimate;
};

struct PairingSettings {
  /// Between two poses of the truth: a longer gap says nothing about what lies in it. Two steps of
  /// KITTI's 10 Hz, and forty of EuRoC's.
  double most_gap_s = 0.2;
  double offset_s = 0.0;  ///< added to the estimate's times before they are looked up
};

struct PairedPoses {
  std::vector<PosePair> pairs;
  std::size_t outside = 0;  ///< poses of the estimate before the truth begins or after it ends
  std::size_t in_gaps = 0;  ///< in gaps of the truth
  std::vector<std::string> remarks;
};

/// The truth at the estimate's times: position linearly, rotation along the shortest arc (slerp)
/// between the two poses around it; of two trajectories without times the poses of one number.
/// @throws UserError where fewer than three belong together, saying why
[[nodiscard]] PairedPoses pair_poses(const datasets::Trajectory& truth,
                                     const datasets::Trajectory& estimate,
                                     const PairingSettings& settings);

/// The pose between two, at a share of 0..1 of the way.
[[nodiscard]] datasets::TimedPose between(const datasets::TimedPose& a,
                                          const datasets::TimedPose& b, double share);

}  // namespace striate::evaluation
