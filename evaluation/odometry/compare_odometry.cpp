#include "striate/evaluation/odometry/compare_odometry.hpp"

#include <ctime>

#include "striate/base/user_error.hpp"

namespace striate::evaluation {

double processor_s() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

void take_pose(const perception::VisualPose& pose, std::size_t number,
               std::optional<std::int64_t> stamp_ns, const cv::Matx33d& left_turn, MethodRun& run) {
  ++run.views;
  run.known += pose.known();
  run.begun_anew += pose.begun_anew;
  run.estimate.timed = stamp_ns.has_value();
  if (!pose.placed()) {
    ++run.without;
    ++run.why[perception::word_of(pose.reason)];
    return;
  }
  run.noise_px += pose.noise_px;
  const auto counted = static_cast<std::int64_t>(number) * 1'000'000'000;
  run.estimate.poses.push_back(
      raw_camera_pose(pose.world_from_camera, left_turn, stamp_ns.value_or(counted)));
}

void take_means(MethodRun& run) {
  if (run.views > 0) run.ms /= static_cast<double>(run.views);
  if (run.estimate.poses.size() > 1) {
    run.noise_px /= static_cast<double>(run.estimate.poses.size() - 1);
  }
}

double estimated_way_m(const MethodRun& run) {
  double way_m = 0.0;
  for (std::size_t k = 1; k < run.estimate.poses.size(); ++k) {
    way_m += cv::norm(run.estimate.poses[k].position_m - run.estimate.poses[k - 1].position_m);
  }
  return way_m;
}

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
      const double before_s = processor_s();
      const perception::VisualPose& pose = odometries[m].see(view.view);
      runs[m].ms += 1e3 * (processor_s() - before_s);
      take_pose(pose, view.number, view.stamp_ns, views.rectifier().left_turn(), runs[m]);
    }
  }
  for (MethodRun& run : runs) take_means(run);
  return runs;
}

void score_runs(const datasets::Trajectory& truth, const OdometryOptions& options,
                std::vector<MethodRun>& runs) {
  for (MethodRun& run : runs) {
    if (run.estimate.poses.empty()) {
      run.why_no_scores = "no view had an estimate";
    } else if (truth.timed != run.estimate.timed) {
      run.why_no_scores =
          truth.timed
              ? "the truth has times and the sequence has none\n    hint: a truth in KITTI's "
                "format is paired by the number of the pose"
              : "the truth has no times and the sequence has\n    hint: KITTI's poses get "
                "theirs from times.txt beside them";
    } else {
      try {
        run.scores = score_odometry(truth, run.estimate, options);
      } catch (const UserError& error) {
        run.why_no_scores = error.what();
      }
    }
  }
}

double end_error_m(const OdometryScores& scores) {
  return motion_error(scores.poses.pairs.front(), scores.poses.pairs.back()).way_m;
}

}  // namespace striate::evaluation
