#include "striate/evaluation/odometry/compare_odometry.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "striate/app/odometry_picture.hpp"
#include "striate/app/perceive_files.hpp"
#include "striate/app/perceive_sequence.hpp"
#include "striate/app/sequence_odometry.hpp"
#include "striate/base/files.hpp"
#include "striate/base/say.hpp"
#include "striate/platform/datasets/calibration/read_sensor_place.hpp"

namespace striate::app {
namespace {

/// The truth of a set of EuRoC's is of the body, and its own file says where the camera is on it.
std::string sensor_of(const JudgedSequence& judged, const std::filesystem::path& truth) {
  if (!judged.sensor.empty()) return judged.sensor;
  if (truth.parent_path().filename() != "state_groundtruth_estimate0") return {};
  const std::filesystem::path sensor = truth.parent_path().parent_path() / "cam0" / "sensor.yaml";
  std::error_code error;
  if (!std::filesystem::exists(sensor, error)) return {};
  say(stderr, fmt::format("  note: the truth is of the body; {} says where the camera is\n",
                          sensor.string()));
  return sensor.string();
}

void score_with_truth(const std::string& from, const JudgedSequence& judged,
                      std::vector<evaluation::MethodRun>& runs) {
  const std::filesystem::path file = datasets::ground_truth_file(from);
  std::error_code error;  // of a video, the file itself is no truth
  const bool may_hold_one = std::filesystem::is_directory(from, error) && !file.empty();
  if (judged.truth.empty() && !may_hold_one) {
    say(stderr, "  note: no ground truth was found: --truth FILE\n");
    return;
  }
  datasets::Trajectory truth = datasets::find_ground_truth(from);
  say(stderr,
      fmt::format("truth: {}, {} poses of {}\n", file.string(), truth.poses.size(), truth.format));
  for (const std::string& remark : truth.remarks) say(stderr, "  note: " + remark + "\n");
  const std::string sensor = sensor_of(judged, file);
  if (!sensor.empty()) move_to_sensor(sensor, truth);
  evaluation::score_runs(truth, judged.scores, runs);
  for (const evaluation::MethodRun& run : runs) {
    if (!run.scores) continue;
    for (const std::string& remark : run.scores->poses.remarks) {
      say(stderr, fmt::format("  note: {}: {}\n", run.name, remark));
    }
  }
}

}  // namespace

void move_to_sensor(const std::string& file, datasets::Trajectory& truth) {
  const cv::Matx44d body_from_sensor = datasets::read_sensor_place(file);
  const cv::Matx33d turn = body_from_sensor.get_minor<3, 3>(0, 0);
  const cv::Vec3d way(body_from_sensor(0, 3), body_from_sensor(1, 3), body_from_sensor(2, 3));
  for (datasets::TimedPose& pose : truth.poses) {
    pose.position_m += pose.rotation * way;
    pose.rotation = pose.rotation * turn;
  }
}

int compare_odometry(const SequenceOdometryOptions& options, const JudgedSequence& judged) {
  make_folder(options.out, "--out");
  const auto sequence = datasets::open_sequence(options.source, options.sequence);
  tell_sequence(*sequence);
  const std::size_t told = sequence->remarks().size();
  evaluation::SequenceViews views(*sequence, options.rectified);
  std::vector<evaluation::MethodRun> runs = evaluation::run_methods(
      views, evaluation::odometry_methods(), options.odometry, options.stopped);
  tell_left_out(*sequence, told);
  if (options.stopped && options.stopped()) return 130;
  score_with_truth(judged.truth.empty() ? options.source : judged.truth, judged, runs);
  fmt::print("{}", options.json ? evaluation::runs_json(runs, judged.scores)
                                : evaluation::runs_text(runs, judged.scores));
  if (options.out.empty()) return 0;
  evaluation::write_runs(runs, judged.scores, options.out);
  for (const evaluation::MethodRun& run : runs) {
    if (!run.scores) continue;
    write_picture(std::filesystem::path(options.out) / run.name / "odometry.png",
                  draw_odometry(*run.scores));
  }
  return 0;
}

}  // namespace striate::app
