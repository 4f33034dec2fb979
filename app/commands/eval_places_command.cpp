#include "striate/app/commands/eval_places_command.hpp"

#include <fmt/format.h>

#include <memory>
#include <optional>

#include "striate/app/command_line/whole_number.hpp"
#include "striate/app/commands/sequence_options.hpp"
#include "striate/app/interrupt.hpp"
#include "striate/app/odometry_truth.hpp"
#include "striate/app/perceive_sequence.hpp"
#include "striate/base/files.hpp"
#include "striate/base/plain_text.hpp"
#include "striate/base/say.hpp"
#include "striate/base/user_error.hpp"
#include "striate/evaluation/places/eval_places.hpp"

namespace striate::app {
namespace {

struct EvalPlacesCommand {
  std::string source;
  SequenceArguments sequence;
  std::string truth;
  std::string out = "out/eval_places";
  bool json = false;
  evaluation::PlaceEvalOptions options;
};

/// The trajectory of a sequence, where it has one or one was given.
std::optional<datasets::Trajectory> place_trajectory(const EvalPlacesCommand& given) {
  std::string path = given.truth;
  std::error_code error;
  if (path.empty() && std::filesystem::is_directory(given.source, error) &&
      !datasets::ground_truth_file(given.source).empty()) {
    path = given.source;
  }
  if (path.empty()) {
    say(stderr, "  note: no ground truth was found: --truth FILE\n");
    return {};
  }
  if (evaluation::is_place_labels(path)) return {};
  datasets::Trajectory truth = datasets::find_ground_truth(path);
  tell_trajectory("truth", datasets::ground_truth_file(path).string(), truth);
  return truth;
}

/// KITTI's poses have no times where the pictures have none.
evaluation::PlaceTruth place_truth(const EvalPlacesCommand& given,
                                   const std::optional<datasets::Trajectory>& trajectory,
                                   const std::vector<evaluation::PlacedImage>& images) {
  if (!trajectory) {
    return evaluation::PlaceTruth::of_labels(given.truth, images, given.options.truth);
  }
  if (trajectory->timed && !images.empty() && !images.front().stamp_ns) {
    const std::string& path = given.truth.empty() ? given.source : given.truth;
    return evaluation::PlaceTruth::of_trajectory(
        datasets::find_ground_truth(path, datasets::KittiTimes::left_out), images,
        given.options.truth);
  }
  return evaluation::PlaceTruth::of_trajectory(*trajectory, images, given.options.truth);
}

/// Enough images that one can be a revisit.
void check_length(const EvalPlacesCommand& given, std::size_t images) {
  if (std::cmp_greater(images, given.options.apart)) return;
  throw UserError(fmt::format(
      "{}: {} images, of which none is {} after another, so that no revisit can be told\n"
      "    hint: a longer sequence, or --apart N for fewer",
      plain_text(given.source), images, given.options.apart));
}

int run_eval_places(const EvalPlacesCommand& given) {
  make_folder(given.out, "--out");
  const auto sequence = datasets::open_sequence(given.source, given.sequence.read());
  tell_sequence(*sequence);
  // Before the run, which takes long: a truth that cannot be read is said at once.
  const std::optional<datasets::Trajectory> trajectory = place_trajectory(given);
  const bool judged = trajectory || !given.truth.empty();
  const std::size_t told = sequence->remarks().size();
  const Interrupt interrupt(Interrupt::BrokenOutput::ends);
  std::vector<evaluation::PlacedImage> images;
  std::vector<evaluation::PlaceRun> runs = evaluation::run_place_methods(
      *sequence, given.options, evaluation::place_methods(given.options.neighbours), images,
      [] { return Interrupt::requested(); });
  tell_left_out(*sequence, told);
  if (Interrupt::requested()) return 130;
  check_length(given, images.size());
  if (judged) {
    evaluation::judge_places(place_truth(given, trajectory, images), given.options, runs);
  }
  fmt::print("{}", given.json ? evaluation::places_json(runs, images, judged)
                              : evaluation::places_text(runs, judged));
  evaluation::write_places(runs, images, judged, given.out);
  return 0;
}

void add_place_truth_options(CLI::App& command, EvalPlacesCommand& given) {
  command
      .add_option("--truth", given.truth,
                  "a trajectory, the folder of a set that holds one, or labels: a line "
                  "\"image,place\", then NAME,NUMBER for each image, where the number grows along "
                  "the way; without it the sequence's own trajectory, if it has one")
      ->type_name("FILE");
  command
      .add_option("--apart", given.options.apart,
                  "images between two looks at a place, at least: nearer ones are no revisit")
      ->check(CLI::Range(1, 1000000))
      ->capture_default_str();
  command
      .add_option("--neighbours", given.options.neighbours,
                  "images that follow each other so closely are of one place and do not contend")
      ->check(CLI::Range(0, 1000000))
      ->capture_default_str();
  command
      .add_option("--within-m", given.options.truth.within_m,
                  "two images of one place are no farther apart, by a trajectory")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command.add_option("--within-deg", given.options.truth.within_deg, "and no more turned")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command
      .add_option("--within-places", given.options.truth.within_places,
                  "numbers of one place differ by no more, by labels")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
}

}  // namespace

void add_eval_places(CLI::App& eval, int& exit_code) {
  auto given = std::make_shared<EvalPlacesCommand>();
  CLI::App* command = eval.add_subcommand(
      "places",
      "Places known again along a sequence: each image is asked for an earlier one of the same\n"
      "place. By Striate (gist, then keypoints), by the gist alone, and by bags of ORB words,\n"
      "alone and with a fundamental matrix. Without a truth it is told what would be claimed.\n"
      "Examples: striate eval places MH_01_easy --apart 50\n"
      "          striate eval places corridor --truth labels.csv --json");
  command->add_option("sequence", given->source, "a folder of pictures, a video or a data set")
      ->type_name("FOLDER")
      ->required();
  add_place_truth_options(*command, *given);
  command->add_option("--out", given->out, "folder for tables and the plot")
      ->type_name("FOLDER")
      ->capture_default_str();
  command->add_flag("--json", given->json, "print JSON instead of text");
  add_sequence_options(*command, given->sequence);
  command->callback([given, &exit_code] { exit_code = run_eval_places(*given); });
}

}  // namespace striate::app
