#include <benchmark/benchmark.h>

#include <opencv2/imgproc.hpp>
#include <opencv2/saliency.hpp>

#include "striate/perception/saliency/saliency.hpp"
#include "tests/benchmarks/in_turns.hpp"
#include "tests/reference/test_images.hpp"

/// saliency_benchmark: salience of a 160x120 image, ours and OpenCV's two methods, in turns.
namespace striate {
namespace {

/// A coloured texture with two things in it.
cv::Mat3b image() {
  cv::Mat3b image;
  cv::cvtColor(reference::texture({160, 120}, 1, 0, 50), image, cv::COLOR_GRAY2BGR);
  image(cv::Rect(30, 40, 24, 30)) += cv::Scalar(0, 0, 90);
  image(cv::Rect(100, 60, 20, 20)) += cv::Scalar(90, 0, 0);
  return image;
}

perception::DisparityMap disparity() {
  perception::DisparityMap map;
  map.disparity_px = cv::Mat1f(120, 160, 3.0F);
  map.confidence = cv::Mat1f(120, 160, 0.9F);
  map.disparity_px(cv::Rect(30, 40, 24, 30)).setTo(14.0F);
  return map;
}

void ours(benchmark::State& state, const perception::SaliencySettings& settings, bool depth) {
  const cv::Mat3b bgr = image();
  const perception::DisparityMap map = depth ? disparity() : perception::DisparityMap{};
  const perception::ViewGeometry geometry(map, {}, {});
  perception::SaliencyFinder finder(settings);
  for (auto _ : state) benchmark::DoNotOptimize(finder.find(bgr, map, geometry).regions.size());
}

void opencv(benchmark::State& state, cv::Ptr<cv::saliency::StaticSaliency> method) {
  const cv::Mat3b bgr = image();
  cv::Mat map;
  for (auto _ : state) benchmark::DoNotOptimize(method->computeSaliency(bgr, map));
}

}  // namespace
}  // namespace striate

int main(int argc, char** argv) {
  using namespace striate;
  InTurns in_turns(argc, argv, 15, "0.05");
  if (in_turns.refuse_arguments()) return 2;
  const auto add = [](const char* name, const auto& function) {
    benchmark::RegisterBenchmark(name, function)->Unit(benchmark::kMicrosecond);
  };
  perception::SaliencySettings paper, robust, moving;
  paper.mode = perception::SaliencyMode::paper;
  moving.motion = 1.0;
  add("paper", [=](auto& state) { ours(state, paper, false); });
  add("robust", [=](auto& state) { ours(state, robust, false); });
  add("paper, with depth", [=](auto& state) { ours(state, paper, true); });
  add("robust, with depth", [=](auto& state) { ours(state, robust, true); });
  add("robust, with depth and motion", [=](auto& state) { ours(state, moving, true); });
  add("OpenCV spectral residual",
      [](auto& state) { opencv(state, cv::saliency::StaticSaliencySpectralResidual::create()); });
  add("OpenCV fine-grained",
      [](auto& state) { opencv(state, cv::saliency::StaticSaliencyFineGrained::create()); });
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
