#include "striate/evaluation/odometry/compare_odometry.hpp"

#include <ctime>

#include "striate/base/user_error.hpp"

namespace striate::evaluation {
namespace {

/// Of this thread, s: what others do on the machine does not count.
double processor_s() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

void take_pose(const perception::VisualPose& pose, const SequenceView& view,
               const cv::Matx33d& left_turn, MethodRun& run) {
  ++run.views;
  run.begun_anew += pose.begun_anew;
  const bool begins = pose.reason == perception::NoEstimate::beginning && !pose.begun_anew;
  if (!pose.known() && !begins) {
    ++run.without;
    ++run.why[perception::word_of(pose.reason)];
    return;
  }
  run.noise_px += pose.noise_px;
  const auto counted = static_cast<std::int64_t>(view.number) * 1'000'000'000;
  run.estimate.poses.push_back(
      raw_camera_pose(pose.world_from_camera, left_turn, view.stamp_ns.value_or(counted)));
}

/// Poses without times are paired by their number, which the truth then counts, too.
datasets::Trajectory as_counted(datasets::Trajectory truth) {
  truth.timed = false;
  for (std::size_t k = 0; k < truth.poses.size(); ++k) {
    truth.poses[k].stamp_ns = static_cast<std::int64_t>(k) * 1'000'000'000;
  }
  return truth;
}

/// How far the turns of the estimate are from the true ones, the median, rad.
double turns_apart_rad(const std::vector<PosePair>& pairs, bool inverted) {
  std::vector<double> apart_rad;
  for (std::size_t k = 0; 2 * k < pairs.size(); ++k) {
    const PosePair& a = pairs[k];
    const PosePair& b = pairs[k + pairs.size() / 2];
    const cv::Matx33d truth = inverted ? a.truth.rotation * b.truth.rotation.t()
                                       : a.truth.rotation.t() * b.truth.rotation;
    const cv::Matx33d estimate = a.estimate.rotation.t() * b.estimate.rotation;
    apart_rad.push_back(cv::norm(perception::turn_of(truth.t() * estimate)));
  }
  return figures_of(apart_rad).median;
}

/// Files are about in which the rotation is that of the world in the camera, whatever they say. The
/// turns of any estimate tell which: one of the two fits many times better.
bool rotations_are_inverted(const std::vector<PosePair>& pairs) {
  constexpr double kClearly_rad = 0.02;  // a degree: less is the estimate's own error (by hand)
  constexpr double kTimesBetter = 5.0;   // ratio of the two errors (by hand)
  const double as_said_rad = turns_apart_rad(pairs, false);
  return as_said_rad > kClearly_rad && as_said_rad > kTimesBetter * turns_apart_rad(pairs, true);
}

datasets::Trajectory with_inverted_rotations(datasets::Trajectory truth) {
  for (datasets::TimedPose& pose : truth.poses) pose.rotation = pose.rotation.t();
  return truth;
}

}  // namespace

std::vector<MethodRun> run_methods(SequenceViews& views, const std::vector<OdometryMethod>& methods,
                                   const perception::VisualOdometrySettings& settings,
                                   const std::function<bool()>& stopped) {
  std::vector<MethodRun> runs;
  std::vector<perception::VisualOdometry> odometries;
  for (const OdometryMethod& method : methods) {
    runs.emplace_back().name = method.name;
    runs.back().estimate.format = "visual odometry";
    odometries.emplace_back(settings, method.source);
  }
  SequenceView view;
  while (!(stopped && stopped()) && views.next(view)) {
    for (std::size_t m = 0; m < methods.size(); ++m) {
      runs[m].estimate.timed = view.stamp_ns.has_value();
      const double before_s = processor_s();
      const perception::VisualPose& pose = odometries[m].see(view.view);
      runs[m].ms += 1e3 * (processor_s() - before_s);
      take_pose(pose, view, views.rectifier().left_turn(), runs[m]);
    }
  }
  for (MethodRun& run : runs) {
    if (run.views > 0) run.ms /= static_cast<double>(run.views);
    if (run.estimate.poses.size() > 1) {
      run.noise_px /= static_cast<double>(run.estimate.poses.size() - 1);
    }
  }
  return runs;
}

void score_runs(const datasets::Trajectory& truth, const OdometryOptions& options,
                std::vector<MethodRun>& runs) {
  for (MethodRun& run : runs) {
    if (run.estimate.poses.empty()) continue;
    const bool counted = truth.format == "KITTI" && !run.estimate.timed && truth.timed;
    datasets::Trajectory estimate = run.estimate;
    datasets::Trajectory asked = counted ? as_counted(truth) : truth;
    if (!asked.timed && estimate.timed) {
      throw UserError(
          "the truth has no times and the sequence has\n    hint: KITTI's poses get theirs from "
          "times.txt beside them");
    }
    try {
      run.scores = score_odometry(asked, estimate, options);
      if (!rotations_are_inverted(run.scores->poses.pairs)) continue;
      run.scores = score_odometry(with_inverted_rotations(asked), estimate, options);
      run.scores->poses.remarks.push_back(
          "the truth's rotations are those of the world in the camera, not of the camera in the "
          "world as they should be: taken inverted");
    } catch (const UserError& error) {
      if (&run == &runs.front()) throw;  // of our own the person is told why
    }
  }
}

double end_error_m(const OdometryScores& scores) {
  const PosePair& first = scores.poses.pairs.front();
  const PosePair& last = scores.poses.pairs.back();
  const cv::Vec3d truth =
      first.truth.rotation.t() * (last.truth.position_m - first.truth.position_m);
  const cv::Vec3d estimate =
      first.estimate.rotation.t() * (last.estimate.position_m - first.estimate.position_m);
  return cv::norm(truth - estimate);
}

}  // namespace striate::evaluation
