#include "striate/app/commands/eval_odometry_command.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "striate/app/commands/odometry_options.hpp"
#include "striate/app/interrupt.hpp"
#include "striate/app/odometry_picture.hpp"
#include "striate/app/perceive_files.hpp"
#include "striate/app/recorded_odometry.hpp"
#include "striate/app/sequence_odometry.hpp"
#include "striate/base/files.hpp"
#include "striate/base/plain_text.hpp"
#include "striate/base/say.hpp"
#include "striate/base/user_error.hpp"
#include "striate/evaluation/odometry/eval_odometry.hpp"

namespace striate::app {
namespace {

struct EvalOdometryCommand {
  std::string estimate;
  std::string truth;
  std::string times;   ///< of an estimate in KITTI's format
  std::string sensor;  ///< EuRoC's sensor.yaml: where on the body the estimate's camera is
  std::string out = "out/eval_odometry";
  bool json = false;
  SequenceArguments sequence;
  SequenceOdometryOptions visual;
  evaluation::OdometryOptions options;
};

void tell_trajectory(const char* which, const std::string& file,
                     const datasets::Trajectory& trajectory) {
  say(stderr, fmt::format("{}: {}, {} pose{} of {}\n", which, file, trajectory.poses.size(),
                          trajectory.poses.size() == 1 ? "" : "s", trajectory.format));
  for (const std::string& remark : trajectory.remarks) say(stderr, "  note: " + remark + "\n");
}

int run_eval_sequence(const EvalOdometryCommand& given) {
  SequenceOdometryOptions options = given.visual;
  options.source = given.estimate;
  options.sequence = given.sequence.read();
  options.out = given.out;
  options.json = given.json;
  const Interrupt interrupt(Interrupt::BrokenOutput::ends);
  options.stopped = [] { return Interrupt::requested(); };
  return compare_odometry(options, {given.truth, given.sensor, given.options});
}

int run_eval_odometry(const EvalOdometryCommand& given) {
  if (is_sequence(given.estimate)) return run_eval_sequence(given);
  if (given.truth.empty()) {
    throw UserError(fmt::format("{}: is a trajectory, which needs a truth: --truth FILE",
                                plain_text(given.estimate)));
  }
  make_folder(given.out, "--out");
  std::string times = given.times;
  // KITTI's poses find the times of their sequence by themselves where they lie as KITTI's do.
  datasets::Trajectory truth = datasets::find_ground_truth(given.truth);
  const datasets::Trajectory estimate = read_estimate(given.estimate, times);
  if (times.empty() && !estimate.timed && truth.timed && truth.format == "KITTI") {
    // One number a pose in both: the times are the truth's, and pair nothing better.
    truth.timed = false;
    for (std::size_t k = 0; k < truth.poses.size(); ++k) {
      truth.poses[k].stamp_ns = static_cast<std::int64_t>(k) * 1'000'000'000;
    }
  }
  tell_trajectory("truth", given.truth, truth);
  tell_trajectory("estimate", given.estimate, estimate);
  if (!given.sensor.empty()) move_to_sensor(given.sensor, truth);
  const evaluation::OdometryScores scores =
      evaluation::score_odometry(truth, estimate, given.options);
  for (const std::string& remark : scores.poses.remarks) say(stderr, "  note: " + remark + "\n");
  fmt::print("{}", given.json ? evaluation::scores_json(scores, given.options)
                              : evaluation::scores_text(scores, given.options));
  evaluation::write_scores(scores, given.options, given.out);
  write_picture(std::filesystem::path(given.out) / "odometry.png", draw_odometry(scores));
  return 0;
}

}  // namespace

void add_eval_odometry(CLI::App& eval, int& exit_code) {
  auto options = std::make_shared<EvalOdometryCommand>();
  EvalOdometryCommand& given = *options;
  CLI::App* command = eval.add_subcommand(
      "odometry",
      "How far an estimated trajectory is from the truth: ATE after alignment (Sturm et al. "
      "2012),\n"
      "RPE over a fixed time, and KITTI's percent and degrees per metre over stretches of 100 to\n"
      "800 m. Trajectories are files of TUM, KITTI or EuRoC; the estimate may be a recording, of\n"
      "which the wheels' odometry counts. Of a sequence (a folder or a video) visual odometry "
      "makes\n"
      "the estimate: with Striate's keypoints and descriptors, and with ORB's and SIFT's in their\n"
      "place. Writes tables, plots (PNG, SVG) and TUM trajectories.\n"
      "Examples: striate eval odometry my.tum --truth MH_01_easy --out out/mh01\n"
      "          striate eval odometry kitti/sequences/00");
  command
      ->add_option("estimate", given.estimate,
                   "the trajectory that is judged, a recording, or a sequence of pictures")
      ->type_name("FILE")
      ->required();
  command
      ->add_option("--truth", given.truth,
                   "a trajectory, or the folder of a set that holds its ground truth; of a "
                   "sequence its own, where it has one")
      ->type_name("FILE");
  command->add_option("--times", given.times, "times of an estimate in KITTI's format (times.txt)");
  command->add_option("--sensor", given.sensor,
                      "EuRoC's sensor.yaml of the camera that the estimate is of, where the truth "
                      "is of the body: its T_BS counts");
  command->add_flag("--scale", given.options.scale,
                    "align by a similarity: of one camera the scale is unknown");
  command
      ->add_option("--over-s", given.options.over_s,
                   "time of the relative pose error; of trajectories without times: poses")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command
      ->add_option("--lengths-m", given.options.lengths_m,
                   "of the stretches; without it KITTI's, or tenths of a way shorter than 100 m")
      ->allow_extra_args(false)
      ->delimiter(',')
      ->check(CLI::PositiveNumber);
  command
      ->add_option("--most-gap-s", given.options.pairing.most_gap_s,
                   "between two true poses that are interpolated")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command
      ->add_option("--time-offset-s", given.options.pairing.offset_s,
                   "added to the times of the estimate")
      ->check(CLI::Range(-1e9, 1e9))
      ->capture_default_str();
  command->add_option("--out", given.out, "folder for tables, plots and trajectories")
      ->type_name("FOLDER")
      ->capture_default_str();
  command->add_flag("--json", given.json, "print JSON instead of text");
  add_sequence_options(*command, given.sequence);
  add_odometry_options(*command, given.visual);
  command->callback([options, &exit_code] { exit_code = run_eval_odometry(*options); });
}

}  // namespace striate::app
