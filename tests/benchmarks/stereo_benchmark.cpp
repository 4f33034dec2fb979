#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <opencv2/calib3d.hpp>

#include "striate/perception/keypoints/keypoints.hpp"
#include "striate/perception/stereo/stereo_matcher.hpp"
#include "tests/benchmarks/in_turns.hpp"
#include "tests/reference/stereo_reference.hpp"
#include "tests/reference/test_images.hpp"

/// stereo_benchmark: stereo at 160x120 and 320x240 on one core. Methods are run in turns; what
/// counts are the medians of CPU time and their ratios within one run, to the paper setting of the
/// same size. STRIATE_TARGETS (a number, see hwy/targets.h) restricts the instruction sets of our
/// own code.
namespace striate {
namespace {

const std::string kYardstick = "paper, K = 150";
constexpr int kPaperCandidates = 150;
const std::vector<cv::Size> kSizes = {{160, 120}, {320, 240}};

cv::Mat1b left_image(cv::Size size) {
  return reference::with_noise(reference::texture(size, 1), 2.0, 1);
}
cv::Mat1b right_image(cv::Size size) {
  return reference::with_noise(reference::texture(size, 1, 9), 2.0, 2);
}

void exact_reference(benchmark::State& state, cv::Size size) {
  const cv::Mat1b left = left_image(size), right = right_image(size);
  for (auto _ : state) {
    benchmark::DoNotOptimize(reference::paper_stereo(left, right, kPaperCandidates));
  }
}

void ours(benchmark::State& state, cv::Size size, perception::StereoMode mode, int candidates) {
  perception::StereoSettings settings;
  settings.mode = mode;
  settings.candidates = candidates;
  perception::StereoMatcher matcher(settings);
  const cv::Mat1b left = left_image(size), right = right_image(size);
  perception::DisparityMap map;
  for (auto _ : state) {
    matcher.match(left, right, map);
    benchmark::DoNotOptimize(map.disparity_px.data);
  }
}

/// OpenCV leaves the first columns out, as many as it searches disparities: the images are
/// continued to the left, so that all methods have the same pixels to do.
void opencv(benchmark::State& state, cv::Size size, const cv::Ptr<cv::StereoMatcher>& matcher) {
  cv::Mat left, right, disparity;
  const int searched = matcher->getNumDisparities();
  cv::copyMakeBorder(left_image(size), left, 0, 0, searched, 0, cv::BORDER_REPLICATE);
  cv::copyMakeBorder(right_image(size), right, 0, 0, searched, 0, cv::BORDER_REPLICATE);
  for (auto _ : state) {
    matcher->compute(left, right, disparity);
    benchmark::DoNotOptimize(disparity.data);
  }
}

void keypoints(benchmark::State& state) {
  perception::KeypointFinder finder{perception::KeypointSettings{}};
  const cv::Mat1b image = reference::texture({640, 480}, 1);
  for (auto _ : state) benchmark::DoNotOptimize(finder.find(image));
}

void register_size(cv::Size size) {
  auto add = [&](const std::string& name, const auto& function) {
    const std::string full = fmt::format("{}x{}: {}", size.width, size.height, name);
    benchmark::RegisterBenchmark(full.c_str(), function)->Unit(benchmark::kMillisecond);
  };
  auto add_ours = [&](const std::string& name, perception::StereoMode mode, int candidates) {
    add(name, [=](auto& state) { ours(state, size, mode, candidates); });
  };
  add("paper, double, direct", [=](auto& state) { exact_reference(state, size); });
  add_ours(kYardstick, perception::StereoMode::paper, kPaperCandidates);
  add_ours("paper, K = 64", perception::StereoMode::paper, 64);
  add_ours("robust, K = 64", perception::StereoMode::robust, 64);
  add_ours("robust, K = 128", perception::StereoMode::robust, 128);
  for (const int searched : {64, 160}) {
    add(fmt::format("StereoBM 9, K = {}", searched),
        [=](auto& state) { opencv(state, size, cv::StereoBM::create(searched, 9)); });
    for (const auto& [name, mode] : {std::pair{"SGBM", cv::StereoSGBM::MODE_SGBM},
                                     {"SGBM 3WAY", cv::StereoSGBM::MODE_SGBM_3WAY},
                                     {"SGBM HH", cv::StereoSGBM::MODE_HH}}) {
      add(fmt::format("{}, K = {}", name, searched), [=, mode = mode](auto& state) {
        opencv(state, size,
               cv::StereoSGBM::create(0, searched, 3, 72, 288, 1, 63, 10, 100, 2, mode));
      });
    }
  }
}

void register_all() {
  for (const cv::Size size : kSizes) register_size(size);
  benchmark::RegisterBenchmark("keypoints 640x480", keypoints)->Unit(benchmark::kMillisecond);
}

}  // namespace
}  // namespace striate

int main(int argc, char** argv) {
  striate::InTurns turns(argc, argv, 9, "0.05");
  if (turns.refuse_arguments()) return 2;
  striate::register_all();
  striate::Medians medians;
  benchmark::RunSpecifiedBenchmarks(&medians);
  medians.print_ratios([](const std::string& name) {
    return name.substr(0, name.find(": ")) + ": " + striate::kYardstick;
  });
  return 0;
}
