#include <memory>

#include "striate/app/command_line/whole_number.hpp"
#include "striate/app/commands/commands.hpp"
#include "striate/app/commands/sequence_options.hpp"
#include "striate/app/interrupt.hpp"
#include "striate/app/recognise.hpp"

namespace striate::app {
namespace {

struct RecogniseCommand {
  RecogniseOptions options;
  SequenceArguments sequence;
};

int run_recognise(const RecogniseCommand& given) {
  RecogniseOptions options = given.options;
  options.sequence = given.sequence.read();
  const Interrupt interrupt(Interrupt::BrokenOutput::ends);
  options.stopped = [] { return Interrupt::requested(); };
  return recognise(options);
}

}  // namespace

void add_recognise_command(CLI::App& app, int& exit_code) {
  auto given = std::make_shared<RecogniseCommand>();
  RecogniseOptions& options = given->options;
  CLI::App* command = app.add_subcommand(
      "recognise",
      "Says which taught landmarks a picture shows, and where: of one picture, a folder, a video\n"
      "or a sequence. With two eyes and their calibration it says how far they are, too.\n"
      "Exit code 0 where something was recognised, 1 where nothing was.\n"
      "Examples: striate recognise table.jpg --memory home.db --out out\n"
      "          striate recognise MH_01_easy --memory home.db --every 10 --json");
  command->add_option("source", options.source, "a picture, a folder of them, a video, a sequence")
      ->type_name("FILE")
      ->required();
  command->add_option("--memory", options.memory, "the memory that was taught")
      ->capture_default_str();
  command
      ->add_option("--only", options.only, "look for this landmark alone; several: several times")
      ->type_name("NAME")
      ->allow_extra_args(false);
  command->add_option("--out", options.out, "folder for the annotated pictures")
      ->type_name("FOLDER");
  command
      ->add_option("--least-inliers", options.settings.least_inliers,
                   "keypoints that must agree on a place; fewer find more and err more")
      ->check(CLI::Range(3, 1000))
      ->capture_default_str();
  add_sequence_options(*command, given->sequence);
  command->add_flag("--rectified", options.rectified,
                    "the pictures are rectified already; the calibration is of the raw ones");
  CLI::Option* focal = command
                           ->add_option("--focal-px", options.focal_px,
                                        "instead of a calibration, of rectified pairs")
                           ->check(CLI::PositiveNumber);
  CLI::Option* baseline =
      command->add_option("--baseline-m", options.baseline_m, "distance of the two cameras")
          ->needs(focal)
          ->check(CLI::PositiveNumber);
  focal->needs(baseline);
  command->add_flag("--json", options.json, "print a JSON object a line instead of text");
  command->callback([given, &exit_code] { exit_code = run_recognise(*given); });
}

}  // namespace striate::app
