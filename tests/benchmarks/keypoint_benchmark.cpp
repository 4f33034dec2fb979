#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <opencv2/features2d.hpp>

#include "striate/perception/keypoints/keypoints.hpp"
#include "tests/benchmarks/one_image.hpp"

/// keypoint_benchmark [PICTURE]: keypoints with descriptors at 640x480 on one core; without a
/// image on a texture made by rule. Methods are run in turns; what counts are the medians of CPU
/// time and their ratios within one run. STRIATE_TARGETS (a number, see hwy/targets.h) restricts
/// the instruction sets of our own code.
namespace striate {
namespace {

const char* const kYardstick = "ORB, 500";

void ours(benchmark::State& state, const cv::Mat1b& image,
          const perception::KeypointSettings& settings) {
  perception::KeypointFinder finder(settings);
  std::vector<perception::Keypoint> found;
  for (auto _ : state) {
    finder.find(image, found);
    benchmark::DoNotOptimize(found.data());
  }
  state.counters["found"] = static_cast<double>(found.size());
}

void opencv(benchmark::State& state, const cv::Mat1b& image, const cv::Ptr<cv::Feature2D>& method) {
  std::vector<cv::KeyPoint> found;
  cv::Mat descriptors;
  for (auto _ : state) {
    method->detectAndCompute(image, cv::noArray(), found, descriptors);
    benchmark::DoNotOptimize(descriptors.data);
  }
  state.counters["found"] = static_cast<double>(found.size());
}

void register_all(const cv::Mat1b& image) {
  auto add = [&](const char* name, const auto& function, const auto& what) {
    benchmark::RegisterBenchmark(name, [=](auto& state) {
      function(state, image, what);
    })->Unit(benchmark::kMillisecond);
  };
  perception::KeypointSettings robot, many, fine, scales;
  robot.most = fine.most = 500;
  fine.wavelength_px = scales.wavelength_px = 4.0;
  fine.halve = scales.halve = false;
  scales.scales = 9;
  add("lambda 8 halved, 500", ours, robot);
  add("lambda 8 halved, 1000", ours, many);
  add("lambda 4, 500", ours, fine);
  add("lambda 4 .. 64, 1000", ours, scales);
  add(kYardstick, opencv, cv::Ptr<cv::Feature2D>(cv::ORB::create(500)));
  add("BRISK, 3 octaves", opencv, cv::Ptr<cv::Feature2D>(cv::BRISK::create(30, 3)));
}

}  // namespace
}  // namespace striate

int main(int argc, char** argv) {
  striate::InTurns turns(argc, argv, 9, "0.05");
  return striate::run_on_one_image(turns, "keypoint_benchmark", striate::register_all,
                                   striate::kYardstick);
}
