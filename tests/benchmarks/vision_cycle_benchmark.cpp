#include <benchmark/benchmark.h>

#include <cmath>
#include <opencv2/imgproc.hpp>

#include "perception/perception.hpp"
#include "perception/recognition/recogniser.hpp"
#include "tests/reference/test_pictures.hpp"

/// vision_cycle_benchmark: all of seeing on one core, in every picture: robust stereo at 160x120,
/// obstacles, corridor, saliency, keypoints at 640x480, and recognition on the salient regions
/// against 50 landmarks with 5 views of 150 descriptors; and its dearest stages by themselves.
namespace striate {
namespace {

cv::Mat1b eye(int shift_px) {
  const cv::Mat1b fine = reference::texture({320, 240}, 1, shift_px / 2);
  cv::Mat1b picture;
  cv::resize(fine, picture, {640, 480}, 0, 0, cv::INTER_CUBIC);
  return reference::with_noise(picture, 2.0, shift_px + 1);
}

StereoFrame frame() {
  StereoFrame frame;
  cv::cvtColor(eye(0), frame.left, cv::COLOR_GRAY2BGR);
  cv::cvtColor(eye(20), frame.right, cv::COLOR_GRAY2BGR);
  frame.left(cv::Rect(100, 120, 120, 90)) += cv::Scalar(0, 0, 90);
  frame.left(cv::Rect(400, 250, 90, 120)) += cv::Scalar(90, 0, 0);
  frame.focal_px = 812.0;
  frame.centre_u_px = 319.5;
  frame.centre_v_px = 239.5;
  frame.baseline_m = 0.12;
  return frame;
}

PerceptionSettings in_every_picture() {
  PerceptionSettings settings;
  settings.keypoints_every = 1;
  settings.saliency_every = 1;
  return settings;
}

std::vector<ObjectModel> landmarks() {
  KeypointSettings settings;
  settings.most = 150;
  settings.threshold = 0.0;
  std::vector<ObjectModel> models(50);
  for (int k = 0; k < 250; ++k) {
    const cv::Mat1b picture = reference::texture({320, 240}, 100 + k);
    auto find = [&](const cv::Mat1b& grey) { return find_keypoints(grey, settings); };
    models[static_cast<std::size_t>(k / 5)].views.push_back(
        make_view(picture, {0, 0, 320, 240}, find));
  }
  return models;
}

/// The keypoints that lie in any salient region; regions are at the working size.
void keep_salient(const Percept& percept, std::vector<Keypoint>& salient) {
  const double zoom = 640.0 / percept.saliency.salience.cols;
  salient.clear();
  for (const Keypoint& point : percept.keypoints) {
    const double u = (point.u_px + 0.5) / zoom - 0.5, v = (point.v_px + 0.5) / zoom - 0.5;
    for (const SalientRegion& region : percept.saliency.regions) {
      if (std::abs(u - region.u_px) > region.width_px / 2) continue;
      if (std::abs(v - region.v_px) > region.height_px / 2) continue;
      salient.push_back(point);
      break;
    }
  }
}

void whole_cycle(benchmark::State& state, int limit_bits) {
  Perception perception(in_every_picture(), {});
  RecognitionSettings settings;
  settings.limit_bits = limit_bits;
  Recogniser recogniser(landmarks(), settings);
  const StereoFrame pictures = frame();
  std::vector<Keypoint> salient;
  for (auto _ : state) {
    const Percept percept = perception.see(pictures);
    keep_salient(percept, salient);
    benchmark::DoNotOptimize(recogniser.recognise(salient).size());
  }
  state.counters["salient keypoints"] = static_cast<double>(salient.size());
  state.counters["cycles/s"] =
      benchmark::Counter(static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}

void seeing_without(benchmark::State& state, bool keypoints) {
  PerceptionSettings settings = in_every_picture();
  settings.keypoints_every = keypoints ? 1 : 0;
  Perception perception(settings, {});
  const StereoFrame pictures = frame();
  for (auto _ : state) benchmark::DoNotOptimize(perception.see(pictures).valid);
}

void stereo(benchmark::State& state) {
  StereoMatcher matcher(StereoSettings{});
  const cv::Mat1b left = to_working_size(frame().left, 160);
  const cv::Mat1b right = to_working_size(frame().right, 160);
  DisparityMap map;
  for (auto _ : state) matcher.match(left, right, map);
}

/// All keypoints of the picture, not the salient ones alone.
void recognition(benchmark::State& state) {
  Recogniser recogniser(landmarks(), {});
  const std::vector<Keypoint> seen = find_keypoints(eye(0), {});
  for (auto _ : state) benchmark::DoNotOptimize(recogniser.recognise(seen).size());
  state.counters["keypoints"] = static_cast<double>(seen.size());
}

}  // namespace
}  // namespace striate

int main(int argc, char** argv) {
  cv::setNumThreads(1);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  auto add = [](const char* name, const auto& function) {
    benchmark::RegisterBenchmark(name, function)->Unit(benchmark::kMillisecond);
  };
  add("whole cycle", [](auto& state) { striate::whole_cycle(state, 84); });
  add("whole cycle, pairs below 48 bits", [](auto& state) { striate::whole_cycle(state, 48); });
  add("seeing", [](auto& state) { striate::seeing_without(state, true); });
  add("seeing without keypoints", [](auto& state) { striate::seeing_without(state, false); });
  add("stereo 160x120, robust", striate::stereo);
  add("recognition, whole picture", striate::recognition);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
