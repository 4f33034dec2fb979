#include <memory>

#include "striate/app/commands/commands.hpp"
#include "striate/app/perceive.hpp"

namespace striate::app {

void add_perceive_command(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<PerceiveOptions>();
  PerceiveOptions& given = *options;
  CLI::App* command = app.add_subcommand(
      "perceive",
      "Shows what the vision makes of an image pair, or of one image: disparity.pfm,\n"
      "confidence.pfm, obstacles.json, saliency.png, keypoints.json and overview.png.\n"
      "Example: striate perceive --left L.png --right R.png --out out --focal-px 436.2 "
      "--baseline-m 0.11");
  command->add_option("--left", given.left, "the left image")->required();
  CLI::Option* right =
      command->add_option("--right", given.right, "the right image, rectified like the left");
  command->add_option("--out", given.out, "folder for what comes out")
      ->type_name("FOLDER")
      ->required();
  command->add_option("--mode", given.mode, "the paper's own, or the robust one")
      ->check(CLI::IsMember({"paper", "robust"}))
      ->capture_default_str();
  command->add_option("--width-px", given.width_px, "working width")
      ->check(CLI::Range(32, 640))
      ->capture_default_str();
  command
      ->add_option("--candidates", given.candidates,
                   "how many disparities are searched, one a pixel of the working width; 0: 150 at "
                   "width 160")
      ->needs(right)
      ->check(CLI::Range(0, 256))
      ->capture_default_str();
  CLI::Option* focal =
      command->add_option("--focal-px", given.focal_px, "focal length of the given images")
          ->needs(right)
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
      command
          ->add_option("--camera-height-m", given.camera_height_m,
                       "of the lens above the floor; without it obstacles are near blobs")
          ->needs(focal);
  command->add_option("--tilt-deg", given.tilt_deg, "of the camera, up positive")
      ->needs(height)
      ->check(CLI::Range(-60.0, 60.0));
  command->callback([options, &exit_code] { exit_code = perceive(*options); });
}

}  // namespace striate::app
