#pragma once

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "tests/scenarios/striate_here.hpp"

/// Memories taught from images that are made here, and looked into by the command.
namespace striate::scenarios {

/// A print of blots, another for each seed.
inline std::string image_of_a_thing(const TemporaryFolder& folder, int seed) {
  cv::Mat3b image(240, 320, cv::Vec3b(200, 200, 200));
  cv::RNG random(static_cast<std::uint64_t>(seed) + 1);
  for (int k = 0; k < 120; ++k) {
    const cv::Point at(random.uniform(10, 310), random.uniform(10, 230));
    const cv::Scalar colour(random.uniform(0, 256), random.uniform(0, 256), random.uniform(0, 256));
    cv::rectangle(image, at, at + cv::Point(random.uniform(6, 40), random.uniform(6, 30)), colour,
                  cv::FILLED);
  }
  const std::string file = folder / ("thing_" + std::to_string(seed) + ".png");
  cv::imwrite(file, image);
  return file;
}

inline Ended memory(const std::string& file, std::vector<std::string> words) {
  words.insert(words.begin(), {"memory", file});
  return striate_here(words);
}

inline nlohmann::json memory_json(const std::string& file, std::vector<std::string> words) {
  words.emplace_back("--json");
  const Ended ended = memory(file, words);
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  return nlohmann::json::parse(ended.out);
}

inline void teach(const std::string& file, const std::string& name, const std::string& image) {
  const Ended ended = striate_here({"teach", name, "--image", image, "--memory", file});
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
}

}  // namespace striate::scenarios
