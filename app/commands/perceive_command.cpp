#include <memory>

#include "app/commands/commands.hpp"
#include "app/perceive.hpp"

namespace striate {

void add_perceive_command(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<PerceiveOptions>();
  CLI::App* command = app.add_subcommand(
      "perceive",
      "Shows what the vision makes of a picture pair, or of one picture.\n"
      "Example: striate perceive --left L.png --right R.png --out out --focal-px 436.2 "
      "--baseline-m 0.11");
  command->add_option("--left", options->left, "the left picture")->required();
  command->add_option("--right", options->right, "the right picture, rectified");
  command->add_option("--out", options->out, "folder for what comes out")->required();
  command->add_option("--setting", options->setting, "paper or robust")
      ->check(CLI::IsMember({"paper", "robust"}))
      ->capture_default_str();
  command->add_option("--width", options->width_px, "working width in px")->capture_default_str();
  command
      ->add_option("--candidates", options->candidates,
                   "disparities searched, px at the working width")
      ->capture_default_str();
  command->add_option("--focal-px", options->focal_px, "focal length in px of the given pictures");
  command->add_option("--baseline-m", options->baseline_m, "distance of the two cameras");
  command->add_option("--camera-height-m", options->camera_height_m, "of the lens above the floor");
  command->add_option("--tilt-deg", options->tilt_deg, "of the camera, up positive");
  command->callback([options, &exit_code] { exit_code = perceive(*options); });
}

}  // namespace striate
