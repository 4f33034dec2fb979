#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "striate/evaluation/odometry/eval_odometry.hpp"
#include "striate/evaluation/odometry/rival_features.hpp"
#include "striate/evaluation/odometry/sequence_views.hpp"
#include "striate/perception/visual_odometry/visual_odometry.hpp"

namespace striate::evaluation {

/// What one method made of a sequence.
struct MethodRun {
  std::string name;
  datasets::Trajectory estimate;  ///< of the views with an estimate, and the beginning
  std::size_t views = 0;
  std::size_t known = 0;                   ///< views with an estimate
  std::size_t without = 0;                 ///< views without: neither that nor the beginning
  std::size_t begun_anew = 0;              ///< times that the way is not known
  std::map<std::string, std::size_t> why;  ///< there was none
  double noise_px = 0.0;                   ///< mean of what was measured
  double ms = 0.0;                         ///< a view, mean time of the processor
  std::optional<OdometryScores> scores;    ///< where there is a truth
  std::string why_no_scores;               ///< though there is a truth; empty: there are, or none
};

/// Of this thread, s: what others do on the machine does not count.
[[nodiscard]] double processor_s();

/// Adds what one view gave. @param number of the view: its time in s where it has no stamp
void take_pose(const perception::VisualPose& pose, std::size_t number,
               std::optional<std::int64_t> stamp_ns, const cv::Matx33d& left_turn, MethodRun& run);
/// After the last view: sums of noise and time become means.
void take_means(MethodRun& run);

/// Along the estimate, m.
[[nodiscard]] double estimated_way_m(const MethodRun& run);

/// Every method sees each view in turn, so that all are measured in one run.
/// @param stopped asked before each view; empty: never
[[nodiscard]] std::vector<MethodRun> run_methods(SequenceViews& views,
                                                 const std::vector<OdometryMethod>& methods,
                                                 const perception::VisualOdometrySettings& settings,
                                                 const std::function<bool()>& stopped);

/// Scores each run against the truth, or says why it cannot be.
void score_runs(const datasets::Trajectory& truth, const OdometryOptions& options,
                std::vector<MethodRun>& runs);

/// How far from the true end the estimate ends, where both begin as one, m; the first and last pose
/// that both know.
[[nodiscard]] double end_error_m(const OdometryScores& scores);

[[nodiscard]] std::string runs_text(const std::vector<MethodRun>& runs,
                                    const OdometryOptions& options);
[[nodiscard]] std::string runs_json(const std::vector<MethodRun>& runs,
                                    const OdometryOptions& options);
/// Into `out`: methods.csv, NAME.tum of each, with a truth errors.svg of all, and in NAME/ what
/// write_scores() writes.
void write_runs(const std::vector<MethodRun>& runs, const OdometryOptions& options,
                const std::string& out);

}  // namespace striate::evaluation
