#include "striate/app/commands/sequence_options.hpp"

#include <fmt/format.h>

#include <cmath>

#include "striate/app/command_line/whole_number.hpp"
#include "striate/base/plain_text.hpp"
#include "striate/base/user_error.hpp"
#include "striate/platform/datasets/calibration/text_tree.hpp"

namespace striate::app {

datasets::SequencePlace sequence_place(const std::string& option, const std::string& text) {
  std::string number = text;
  bool seconds = false;
  if (number.ends_with('s')) {
    seconds = true;
    number.pop_back();
    while (number.ends_with(' ')) number.pop_back();
  }
  const auto value = datasets::number_of(number);
  if (value && *value >= 0.0 && (seconds || *value == std::floor(*value))) return {*value, seconds};
  throw UserError(
      fmt::format("{} {}: give the number of a frame, from 0, or a time since the beginning as "
                  "\"3.5 s\"",
                  option, plain_text(text)));
}

datasets::SequenceOptions SequenceArguments::read() const {
  datasets::SequenceOptions result = options;
  if (!from.empty()) result.from = sequence_place("--from", from);
  if (!to.empty()) result.to = sequence_place("--to", to);
  return result;
}

void add_sequence_options(CLI::App& command, SequenceArguments& given) {
  command
      .add_option("--calibration", given.options.calibration,
                  "of the camera, as striate calibrate, OpenCV, ROS, Kalibr, EuRoC, KITTI, "
                  "Middlebury or BoofCV write it; where each eye has a file of its own: twice, the "
                  "left one's first")
      ->type_name("FILE")
      ->allow_extra_args(false);
  command.add_flag("--side-by-side", given.options.side_by_side,
                   "each picture, or frame of a video, holds both eyes, the left one first");
  command.add_flag("--swap", given.options.exchanged, "what is called left is the right eye");
  command.add_option("--every", given.options.every, "take one frame of so many")
      ->check(whole_number_from(1))
      ->capture_default_str();
  command.add_option("--from", given.from, "the first frame: its number, or a time as \"3.5 s\"")
      ->type_name("PLACE");
  command.add_option("--to", given.to, "the last frame, in the same way")->type_name("PLACE");
}

}  // namespace striate::app
