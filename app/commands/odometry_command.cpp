#include <memory>
#include <string>
#include <vector>

#include "striate/app/commands/commands.hpp"
#include "striate/app/commands/odometry_options.hpp"
#include "striate/app/interrupt.hpp"
#include "striate/base/files_apart.hpp"

namespace striate::app {
namespace {

struct OdometryCommand {
  SequenceArguments sequence;
  SequenceOdometryOptions given;
};

int run_odometry(const OdometryCommand& command) {
  SequenceOdometryOptions options = command.given;
  options.sequence = command.sequence.read();
  std::vector<NamedFile> read{{"the sequence", options.source}};
  for (const std::filesystem::path& file : options.sequence.calibration) {
    read.push_back({"--calibration", file.string()});
  }
  check_apart({{"--out", options.out}}, read);
  const Interrupt interrupt(Interrupt::BrokenOutput::ends);
  options.stopped = [] { return Interrupt::requested(); };
  return tell_odometry(options);
}

}  // namespace

void add_odometry_options(CLI::App& command, SequenceOdometryOptions& given) {
  command.add_flag("--rectified", given.rectified,
                   "the pictures are rectified already; the calibration is of the raw ones");
  command
      .add_option(
          "--width-px", given.odometry.width_px,
          "narrow the pictures to it first, which is quicker and less exact; 0: as they are")
      ->check(CLI::Range(0, 4096))
      ->capture_default_str();
  command.add_option("--features", given.odometry.most_features, "keypoints of an eye, at most")
      ->check(CLI::Range(50, 20000))
      ->capture_default_str();
}

void add_odometry_command(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<OdometryCommand>();
  SequenceOdometryOptions& given = options->given;
  CLI::App* command = app.add_subcommand(
      "odometry",
      "Where a stereo camera went, from its pictures alone: of a sequence of EuRoC or KITTI, a\n"
      "folder of pairs, or a video. Prints a line for each pair: the left camera's place in "
      "metres\n"
      "from where it began (x right, y down, z forward), how sure it is, or why there is no\n"
      "estimate. --out keeps the trajectory in TUM's format, of the views with an estimate.\n"
      "Examples: striate odometry MH_01_easy --out mh01.tum\n"
      "          striate odometry my_pairs --calibration stereo.yaml --width-px 640");
  command->add_option("source", given.source, "a sequence, a folder of pairs, or a video")
      ->type_name("FOLDER")
      ->required();
  add_sequence_options(*command, options->sequence);
  add_odometry_options(*command, given);
  command->add_option("--out", given.out, "the trajectory as TUM (time tx ty tz qx qy qz qw)")
      ->type_name("FILE");
  command->add_flag("--json", given.json, "print a JSON object a line instead of text");
  command->callback([options, &exit_code] { exit_code = run_odometry(*options); });
}

}  // namespace striate::app
