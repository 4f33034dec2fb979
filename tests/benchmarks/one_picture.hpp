#pragma once

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "tests/benchmarks/in_turns.hpp"
#include "tests/reference/test_pictures.hpp"

namespace striate {

/// The main function of a benchmark of what is done to one picture of 640x480: that of the command
/// line, or a made texture. Prints medians as multiples of the yardstick's.
inline int run_on_one_picture(InTurns& turns, const std::string& name,
                              const std::function<void(const cv::Mat1b&)>& register_all,
                              const std::string& yardstick) {
  cv::Mat1b picture = reference::texture({640, 480}, 1);
  if (turns.count() > 1) {
    picture = cv::imread(turns.arguments()[1], cv::IMREAD_GRAYSCALE);
    if (!picture.empty()) cv::resize(picture, picture, {640, 480}, 0, 0, cv::INTER_AREA);
  }
  if (turns.count() > 2 || picture.empty()) {
    fmt::print(stderr, "{} [PICTURE]: one picture that can be read\n", name);
    return 2;
  }
  register_all(picture);
  Medians medians;
  benchmark::RunSpecifiedBenchmarks(&medians);
  medians.print_ratios([&](const std::string&) { return yardstick; });
  return 0;
}

}  // namespace striate
