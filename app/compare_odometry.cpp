#include "striate/evaluation/odometry/compare_odometry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "striate/app/odometry_picture.hpp"
#include "striate/app/odometry_truth.hpp"
#include "striate/app/own_camera.hpp"
#include "striate/app/perceive_files.hpp"
#include "striate/app/perceive_sequence.hpp"
#include "striate/app/sequence_odometry.hpp"
#include "striate/base/files.hpp"
#include "striate/base/say.hpp"
#include "striate/base/user_error.hpp"

namespace striate::app {
namespace {

using evaluation::MethodRun;

/// Where its truth is to be found; empty, and said: nowhere.
std::string truth_path(const SequenceOdometryOptions& options, const JudgedSequence& judged) {
  if (!judged.truth.empty()) return judged.truth;
  std::error_code error;  // of a video, the file itself is no truth
  if (std::filesystem::is_directory(options.source, error) &&
      !datasets::ground_truth_file(options.source).empty()) {
    return options.source;
  }
  say(stderr, "  note: no ground truth was found: --truth FILE\n");
  return {};
}

/// Each remark once, with the names of those that it is about where it is not about all.
void tell_remarks(const std::vector<MethodRun>& runs) {
  std::vector<std::pair<std::string, std::vector<std::string>>> told;
  const auto tell = [&](const std::string& remark, const std::string& name) {
    auto same = std::ranges::find(told, remark, [](const auto& one) { return one.first; });
    if (same == told.end()) same = told.insert(told.end(), {remark, {}});
    same->second.push_back(name);
  };
  for (const MethodRun& run : runs) {
    if (!run.why_no_scores.empty()) tell("not judged: " + run.why_no_scores, run.name);
    if (!run.scores) continue;
    for (const std::string& remark : run.scores->poses.remarks) tell(remark, run.name);
  }
  for (const auto& [remark, names] : told) {
    const std::string about =
        names.size() == runs.size() ? "" : fmt::format("{}: ", fmt::join(names, ", "));
    say(stderr, fmt::format("  note: {}{}\n", about, remark));
  }
}

void write_all(const std::vector<MethodRun>& runs, const evaluation::OdometryOptions& options,
               const std::string& out) {
  evaluation::write_runs(runs, options, out);
  for (const MethodRun& run : runs) {
    if (!run.scores) continue;
    write_picture(std::filesystem::path(out) / run.name / "odometry.png",
                  draw_odometry(*run.scores));
  }
}

/// @throws UserError where a truth was given and no run could be judged by it
int exit_code_of(const std::vector<MethodRun>& runs) {
  if (std::ranges::all_of(runs, [](const MethodRun& run) { return run.known == 0; })) return 1;
  if (std::ranges::any_of(runs, [](const MethodRun& run) { return run.scores.has_value(); }) ||
      runs.front().why_no_scores.empty()) {
    return 0;
  }
  throw UserError("no run could be judged: " + runs.front().why_no_scores);
}

}  // namespace

int compare_odometry(const SequenceOdometryOptions& options, const JudgedSequence& judged) {
  make_folder(options.out, "--out");
  const auto sequence = datasets::open_sequence(options.source, options.sequence);
  tell_sequence(*sequence);
  // Before the run, which takes long: a truth that cannot be read is said at once.
  const std::string path = truth_path(options, judged);
  OdometryTruth truth;
  if (!path.empty()) truth = read_truth(path, judged.sensor, datasets::KittiTimes::read);
  const std::size_t told = sequence->remarks().size();
  evaluation::SequenceViews views(*sequence, options.rectified,
                                  [&](const datasets::PictureRectifier& rectifier) {
                                    tell_camera(*sequence->calibration(), rectifier);
                                  });
  std::vector<MethodRun> runs = evaluation::run_methods(views, evaluation::odometry_methods(),
                                                        options.odometry, options.stopped);
  tell_left_out(*sequence, told);
  if (options.stopped && options.stopped()) return 130;
  evaluation::OdometryOptions scores = judged.scores;
  if (!path.empty()) {
    if (!runs.front().estimate.timed) {
      truth.trajectory = datasets::find_ground_truth(path, datasets::KittiTimes::left_out);
    }
    scores.body_from_sensor = truth.body_from_sensor;
    evaluation::score_runs(truth.trajectory, scores, runs);
    tell_remarks(runs);
  }
  if (!options.out.empty()) write_all(runs, scores, options.out);
  fmt::print("{}", options.json ? evaluation::runs_json(runs, scores)
                                : evaluation::runs_text(runs, scores));
  return exit_code_of(runs);
}

}  // namespace striate::app
