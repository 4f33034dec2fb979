#include "striate/app/commands/eval_odometry_command.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <vector>

#include "striate/app/commands/odometry_options.hpp"
#include "striate/app/interrupt.hpp"
#include "striate/app/odometry_picture.hpp"
#include "striate/app/odometry_truth.hpp"
#include "striate/app/perceive_files.hpp"
#include "striate/app/recorded_odometry.hpp"
#include "striate/app/sequence_odometry.hpp"
#include "striate/base/files.hpp"
#include "striate/base/plain_text.hpp"
#include "striate/base/say.hpp"
#include "striate/base/user_error.hpp"
#include "striate/evaluation/odometry/eval_odometry.hpp"
#include "striate/platform/datasets/images/read_image.hpp"

namespace striate::app {
namespace {

struct EvalOdometryCommand {
  std::string estimate;
  std::string truth;
  std::string times;   ///< of an estimate in KITTI's format
  std::string sensor;  ///< as read_truth() takes it
  std::string out = "out/eval_odometry";
  bool json = false;
  SequenceArguments sequence;
  SequenceOdometryOptions visual;
  evaluation::OdometryOptions options;
  std::vector<const CLI::Option*> of_trajectories;  ///< that say nothing of a sequence
  std::vector<const CLI::Option*> of_sequences;     ///< that say nothing of a trajectory
};

/// @param what the estimate is, of which these options say nothing
void refuse_given(const EvalOdometryCommand& given, const std::vector<const CLI::Option*>& options,
                  const char* what) {
  std::string names;
  for (const CLI::Option* option : options) {
    if (option->count() > 0) names += (names.empty() ? "" : ", ") + option->get_name();
  }
  if (names.empty()) return;
  throw UserError(fmt::format("{}: is {}, of which nothing is said by {}",
                              plain_text(given.estimate), what, names));
}

/// @throws UserError where the estimate cannot be a trajectory, or no truth is given
void check_trajectory(const EvalOdometryCommand& given) {
  const std::string name = plain_text(given.estimate);
  std::error_code error;
  if (!std::filesystem::exists(given.estimate, error)) {
    throw UserError(name + ": there is no such file or folder");
  }
  if (datasets::is_image(given.estimate)) {
    throw UserError(name +
                    ": is one picture\n    hint: give a folder of pairs, a video or a trajectory");
  }
  if (given.truth.empty()) {
    throw UserError(name +
                    ": is no sequence of pictures; a trajectory needs a truth: --truth FILE");
  }
}

int run_eval_sequence(const EvalOdometryCommand& given) {
  refuse_given(given, given.of_trajectories, "a sequence of pictures");
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
  refuse_given(given, given.of_sequences, "no sequence of pictures");
  check_trajectory(given);
  make_folder(given.out, "--out");
  const datasets::Trajectory estimate = read_estimate(given.estimate, given.times);
  // Without times poses are paired by their number: those of the truth then pair nothing better.
  const OdometryTruth truth =
      read_truth(given.truth, given.sensor,
                 estimate.timed ? datasets::KittiTimes::read : datasets::KittiTimes::left_out);
  tell_trajectory("estimate", given.estimate, estimate);
  evaluation::OdometryOptions options = given.options;
  options.body_from_sensor = truth.body_from_sensor;
  const evaluation::OdometryScores scores =
      evaluation::score_odometry(truth.trajectory, estimate, options);
  for (const std::string& remark : scores.poses.remarks) say(stderr, "  note: " + remark + "\n");
  fmt::print("{}", given.json ? evaluation::scores_json(scores, options)
                              : evaluation::scores_text(scores, options));
  evaluation::write_scores(scores, options, given.out);
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
  given.of_trajectories.push_back(command->add_option(
      "--times", given.times, "times of an estimate in KITTI's format (times.txt)"));
  command->add_option(
      "--sensor", given.sensor,
      "EuRoC's sensor.yaml of the camera that the estimate is of, where the truth "
      "is of the body: its T_BS counts; without it cam0's of the set; \"body\": the "
      "estimate is of the body, too");
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
  const std::size_t before = command->get_options().size();
  add_sequence_options(*command, given.sequence);
  add_odometry_options(*command, given.visual);
  const auto all = command->get_options();
  given.of_sequences.assign(all.begin() + static_cast<std::ptrdiff_t>(before), all.end());
  command->callback([options, &exit_code] { exit_code = run_eval_odometry(*options); });
}

}  // namespace striate::app
