#include <fmt/format.h>

#include <memory>
#include <utility>

#include "striate/app/commands/commands.hpp"
#include "striate/app/commands/sequence_options.hpp"
#include "striate/app/frame_summary.hpp"
#include "striate/app/interrupt.hpp"
#include "striate/app/perceive.hpp"
#include "striate/app/perceive_sequence.hpp"
#include "striate/base/user_error.hpp"

namespace striate::app {
namespace {

struct PerceiveCommand {
  std::string source;
  SequenceArguments sequence;
  PerceiveOptions frame;
  bool json = false;
};

int run_pair(const PerceiveCommand& given) {
  PerceiveOptions options = given.frame;
  options.calibration = given.sequence.options.calibration;
  options.exchanged = given.sequence.options.exchanged;
  const FrameSummary summary = summary_of(perceive(options).judged);
  fmt::print("{}", given.json ? json_of(summary).dump() + "\n" : text_of(summary));
  return 0;
}

int run_perceive(const PerceiveCommand& given) {
  if (given.source.empty() == given.frame.left.empty()) {
    throw UserError(
        "perceive needs pictures: a folder, a video, a sequence, or one pair\n"
        "    striate perceive FOLDER --calibration FILE --out DIR\n"
        "    striate perceive --left L.png --right R.png --out DIR");
  }
  if (!given.sequence.options.calibration.empty() && given.frame.focal_px > 0.0) {
    throw UserError("--calibration tells focal length and baseline: leave --focal-px away");
  }
  if (given.source.empty()) {
    const bool one_eye = given.frame.right.empty();
    for (const auto& [option, needs_two] : {std::pair("--candidates", given.frame.candidates > 0),
                                            std::pair("--focal-px", given.frame.focal_px > 0.0)}) {
      if (one_eye && needs_two) {
        throw UserError(fmt::format("{} requires --right: one eye has no disparities", option));
      }
    }
    return run_pair(given);
  }
  PerceiveSequenceOptions options;
  options.source = given.source;
  options.sequence = given.sequence.read();
  options.frame = given.frame;
  options.json = given.json;
  const Interrupt interrupt(Interrupt::BrokenOutput::ends);
  options.stopped = [] { return Interrupt::requested(); };
  return perceive_sequence(options);
}

}  // namespace

void add_perceive_command(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<PerceiveCommand>();
  PerceiveOptions& given = options->frame;
  CLI::App* command = app.add_subcommand(
      "perceive",
      "Shows what the vision makes of your pictures: an image pair, one image, a folder of pairs,\n"
      "a video, or a sequence of EuRoC or KITTI. Prints a line for each frame and one for all;\n"
      "--out DIR keeps disparity.pfm, confidence.pfm, obstacles.json, saliency.png,\n"
      "keypoints.json and overview.png, numbered by frame (overview_000012.png).\n"
      "Examples: striate perceive --left L.png --right R.png --out out --focal-px 436.2 "
      "--baseline-m 0.11\n"
      "          striate perceive MH_01_easy --every 10\n"
      "          striate perceive my_pairs --calibration stereo.yaml --out out");
  command
      ->add_option("source", options->source,
                   "a folder of pairs or pictures, a video, a sequence, or one picture")
      ->type_name("FOLDER");
  command->add_option("--left", given.left, "instead: the left image of one pair");
  add_sequence_options(*command, options->sequence);
  command->add_flag("--rectified", given.rectified,
                    "the pictures are rectified already; the calibration is of the raw ones");
  command->add_flag("--json", options->json, "print a JSON object a line instead of text");
  command->add_option("--right", given.right, "the right image, rectified like the left");
  command
      ->add_option("--out", given.out,
                   "folder for what comes out; of a sequence nothing is kept without it")
      ->type_name("FOLDER");
  command->add_option("--mode", given.mode, "the paper's own, or the robust one")
      ->check(CLI::IsMember({"paper", "robust"}))
      ->capture_default_str();
  command->add_option("--width-px", given.width_px, "working width")
      ->check(CLI::Range(kLeastWidth_px, kMostWidth_px))
      ->capture_default_str();
  command
      ->add_option("--candidates", given.candidates,
                   "how many disparities are searched, one a pixel of the working width; 0: 150 at "
                   "width 160")
      ->check(CLI::Range(0, kMostCandidates))
      ->capture_default_str();
  CLI::Option* focal =
      command->add_option("--focal-px", given.focal_px, "focal length of the given images")
          ->check(CLI::PositiveNumber);
  CLI::Option* baseline =
      command->add_option("--baseline-m", given.baseline_m, "distance of the two cameras")
          ->needs(focal)
          ->check(CLI::PositiveNumber);
  focal->needs(baseline);
  command->add_option("--centre-u-px", given.centre_u_px, "principal point; else the middle")
      ->needs(focal);
  command->add_option("--centre-v-px", given.centre_v_px, "principal point; else the middle")
      ->needs(focal);
  CLI::Option* right_centre =
      command
          ->add_option("--right-centre-u-px", given.right_centre_u_px,
                       "principal point of the right image; else where the left one has it")
          ->needs(focal);
  command
      ->add_option("--doffs-px", given.doffs_px,
                   "instead: how far right of the left one's it lies, as in Middlebury's calib.txt")
      ->needs(focal)
      ->excludes(right_centre);
  CLI::Option* height =
      command->add_option("--camera-height-m", given.camera_height_m,
                          "of the lens above the floor; without it obstacles are near blobs");
  command->add_option("--tilt-deg", given.tilt_deg, "of the camera, up positive")
      ->needs(height)
      ->check(CLI::Range(-kMostTilt_deg, kMostTilt_deg));
  command->callback([options, &exit_code] { exit_code = run_perceive(*options); });
}

}  // namespace striate::app
