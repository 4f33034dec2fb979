#pragma once

#include <optional>
#include <string>
#include <vector>

#include "striate/evaluation/odometry/pose_pairs.hpp"

namespace striate::evaluation {

/// Of many errors.
struct ErrorFigures {
  std::size_t count = 0;
  double rmse = 0.0;
  double mean = 0.0;
  double median = 0.0;
  double most = 0.0;
};

/// What lays the estimate over the truth: scale * rotation * p + way.
struct Alignment {
  cv::Matx33d rotation = cv::Matx33d::eye();
  cv::Vec3d way_m{};
  double scale = 1.0;
};

/// The rigid motion (with `scale`: the similarity) of least squares over all positions (Umeyama
/// 1991). Positions on one line leave a turn about it open; it is then the smallest.
[[nodiscard]] Alignment align(const std::vector<PosePair>& pairs, bool scale);
[[nodiscard]] datasets::TimedPose aligned(const datasets::TimedPose& pose, const Alignment& by);

/// Absolute trajectory error (Sturm et al. 2012): how far the aligned positions lie from the true
/// ones, one a pair, in m.
[[nodiscard]] std::vector<double> absolute_errors(const std::vector<PosePair>& pairs,
                                                  const Alignment& alignment);

struct RelativeErrors {
  ErrorFigures way_m;
  ErrorFigures turn_deg;
};

/// Of the motion from one moment to another: (estimated motion)^-1 (true motion).
struct MotionError {
  double way_m = 0.0;
  double turn_rad = 0.0;  ///< 0..pi
};
[[nodiscard]] MotionError motion_error(const PosePair& from, const PosePair& to);

/// Relative pose error (Sturm et al. 2012) over a fixed time: E = (Q_i^-1 Q_j)^-1 (P_i^-1 P_j) for
/// each pair i and the first j that is `over_s` or more later, but no more than half of it too
/// late.
[[nodiscard]] RelativeErrors relative_errors(const std::vector<PosePair>& pairs, double over_s);

/// Of one length of way.
struct LengthErrors {
  double length_m = 0.0;
  std::size_t count = 0;
  double percent = 0.0;    ///< of the way, in translation
  double deg_per_m = 0.0;  ///< of turn
};

struct KittiErrors {
  std::vector<LengthErrors> lengths;
  std::size_t count = 0;  ///< of all stretches
  double percent = 0.0;   ///< mean over all stretches
  double deg_per_m = 0.0;
};

/// As KITTI's development kit counts (Geiger et al. 2012): for every tenth pose and each length the
/// stretch up to the first pose that is farther than it along the true way; E = (estimated
/// motion)^-1 (true motion), its translation and turn over the length.
[[nodiscard]] KittiErrors kitti_errors(const std::vector<PosePair>& pairs,
                                       const std::vector<double>& lengths_m);

/// KITTI's 100 to 800 m as far as the way goes; of a shorter way its tenths up to eight.
[[nodiscard]] std::vector<double> usual_lengths_m(double way_m);

/// Along the true positions, m.
[[nodiscard]] double way_of(const std::vector<PosePair>& pairs);

[[nodiscard]] ErrorFigures figures_of(std::vector<double> errors);

}  // namespace striate::evaluation
