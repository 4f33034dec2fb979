#pragma once

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "tests/benchmarks/in_turns.hpp"
#include "tests/reference/test_images.hpp"

namespace striate {

/// The main function of a benchmark of what is done to one image of 640x480: that of the command
/// line, or a made texture. Prints medians as multiples of the yardstick's.
inline int run_on_one_image(InTurns& turns, const std::string& name,
                            const std::function<void(const cv::Mat1b&)>& register_all,
                            const std::string& yardstick) {
  cv::Mat1b image = reference::texture({640, 480}, 1);
  if (turns.count() > 1) {
    image = cv::imread(turns.arguments()[1], cv::IMREAD_GRAYSCALE);
    if (!image.empty()) cv::resize(image, image, {640, 480}, 0, 0, cv::INTER_AREA);
  }
  if (turns.count() > 2 || image.empty()) {
    fmt::print(stderr, "{} [PICTURE]: one image that can be read\n", name);
    return 2;
  }
  register_all(image);
  Medians medians;
  benchmark::RunSpecifiedBenchmarks(&medians);
  medians.print_ratios([&](const std::string&) { return yardstick; });
  return 0;
}

}  // namespace striate
