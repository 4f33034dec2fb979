#include <benchmark/benchmark.h>

#include <cmath>
#include <opencv2/imgproc.hpp>

#include "striate/perception/perception.hpp"
#include "striate/perception/recognition/oriented_keypoints.hpp"
#include "striate/perception/recognition/recogniser.hpp"
#include "striate/perception/stereo/shrink_by_four.hpp"
#include "tests/benchmarks/in_turns.hpp"
#include "tests/reference/test_images.hpp"

/// vision_cycle_benchmark: seeing and recognising on one core, in every image: robust stereo at
/// 160x120, saliency, keypoints at 640x480, Striate's own descriptor for those in the salient
/// regions, and their recognition against 50 landmarks with 5 views of 150 descriptors; the same
/// with obstacles and the corridor, which is all that the robot does; and the stages by themselves.
namespace striate {
namespace {

constexpr int kLandmarks = 50, kViews = 5;
constexpr std::size_t kDescriptors = 150;  ///< of a view

cv::Mat1b eye(int shift_px) {
  const cv::Mat1b fine = reference::texture({320, 240}, 1, shift_px / 2);
  cv::Mat1b image;
  cv::resize(fine, image, {640, 480}, 0, 0, cv::INTER_CUBIC);
  return reference::with_noise(image, 2.0, shift_px + 1);
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

perception::PerceptionSettings in_every_image() {
  perception::PerceptionSettings settings;
  settings.keypoints_every = 1;
  settings.saliency_every = 1;
  return settings;
}

perception::Recogniser taught() {
  perception::Recogniser recogniser({});
  perception::OrientedSettings settings;
  settings.keypoints = {};
  settings.keypoints.threshold = 0.0;
  settings.keypoints.most = 150;
  perception::OrientedKeypoints oriented(settings);
  for (int k = 0; k < kLandmarks * kViews; ++k) {
    perception::LandmarkView view =
        perception::make_view(reference::texture({320, 240}, 100 + k), {0, 0, 320, 240},
                              [&](const cv::Mat1b& grey) { return oriented(grey); });
    view.descriptors.resize(std::min(view.descriptors.size(), kDescriptors));
    view.keypoints.resize(view.descriptors.size());
    recogniser.add(k / kViews, view);
  }
  return recogniser;
}

/// The keypoints that lie in any salient region; regions are at the working size.
void keep_salient(const std::vector<perception::Keypoint>& keypoints,
                  const perception::SaliencyMap& saliency,
                  std::vector<perception::Keypoint>& salient) {
  const double zoom = 640.0 / saliency.salience.cols;
  salient.clear();
  for (const perception::Keypoint& point : keypoints) {
    const double u = (point.u_px + 0.5) / zoom - 0.5, v = (point.v_px + 0.5) / zoom - 0.5;
    for (const perception::SalientRegion& region : saliency.regions) {
      if (std::abs(u - region.u_px) > region.width_px / 2) continue;
      if (std::abs(v - region.v_px) > region.height_px / 2) continue;
      salient.push_back(point);
      break;
    }
  }
}

void count_cycles(benchmark::State& state, std::size_t salient, std::size_t described) {
  state.counters["salient keypoints"] = static_cast<double>(salient);
  state.counters["descriptors"] = static_cast<double>(described);
  state.counters["cycles/s"] =
      benchmark::Counter(static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}

void whole_cycle(benchmark::State& state) {
  perception::Perception perception(in_every_image(), {});
  perception::Recogniser recogniser = taught();
  perception::OrientedKeypoints oriented(perception::OrientedSettings{});
  const StereoFrame pictures = frame();
  std::vector<perception::Keypoint> salient, described;
  cv::Mat1b grey;
  for (auto _ : state) {
    const perception::Percept percept = perception.see(pictures);
    keep_salient(percept.keypoints, percept.saliency, salient);
    cv::cvtColor(pictures.left, grey, cv::COLOR_BGR2GRAY);
    oriented.describe(grey, salient, described);
    benchmark::DoNotOptimize(recogniser.recognise(described).size());
  }
  count_cycles(state, salient.size(), described.size());
}

/// From two colour images to what is recognised, without obstacles and corridor.
void stereo_to_recognition(benchmark::State& state) {
  perception::StereoMatcher matcher(perception::StereoSettings{});
  perception::SaliencyFinder saliency_finder(in_every_image().saliency);
  perception::KeypointFinder finder{perception::KeypointSettings{}};
  perception::Recogniser recogniser = taught();
  perception::OrientedKeypoints oriented(perception::OrientedSettings{});
  const StereoFrame pictures = frame();
  std::vector<perception::Keypoint> found, salient, described;
  cv::Mat1b grey;
  perception::DisparityMap map;
  for (auto _ : state) {
    cv::cvtColor(pictures.left, grey, cv::COLOR_BGR2GRAY);
    matcher.match(perception::to_fine_working_size(grey, 160),
                  perception::to_fine_working_size(pictures.right, 160), map);
    const perception::SaliencyMap saliency = saliency_finder.find(
        perception::means_of_fours(pictures.left), map, perception::ViewGeometry(map, {}, {}));
    finder.find(grey, found);
    keep_salient(found, saliency, salient);
    oriented.describe(grey, salient, described);
    benchmark::DoNotOptimize(recogniser.recognise(described).size());
  }
  count_cycles(state, salient.size(), described.size());
}

void seeing_without(benchmark::State& state, bool keypoints) {
  perception::PerceptionSettings settings = in_every_image();
  settings.keypoints_every = keypoints ? 1 : 0;
  perception::Perception perception(settings, {});
  const StereoFrame pictures = frame();
  for (auto _ : state) benchmark::DoNotOptimize(perception.see(pictures).valid);
}

void stereo(benchmark::State& state) {
  perception::StereoMatcher matcher(perception::StereoSettings{});
  const cv::Mat1w left = perception::to_fine_working_size(frame().left, 160);
  const cv::Mat1w right = perception::to_fine_working_size(frame().right, 160);
  perception::DisparityMap map;
  for (auto _ : state) matcher.match(left, right, map);
}

void saliency(benchmark::State& state) {
  perception::PerceptionSettings settings = in_every_image();
  settings.keypoints_every = 0;
  perception::SaliencyFinder finder(settings.saliency);
  cv::Mat3b colour;
  cv::resize(frame().left, colour, {160, 120}, 0, 0, cv::INTER_AREA);
  perception::DisparityMap map;
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        finder.find(colour, map, perception::ViewGeometry(map, {}, {})).regions.size());
  }
}

void keypoints(benchmark::State& state) {
  perception::KeypointFinder finder{perception::KeypointSettings{}};
  const cv::Mat1b image = eye(0);
  std::vector<perception::Keypoint> found;
  for (auto _ : state) {
    finder.find(image, found);
    benchmark::DoNotOptimize(found.data());
  }
}

std::vector<perception::Keypoint> salient_keypoints() {
  perception::Perception perception(in_every_image(), {});
  std::vector<perception::Keypoint> salient;
  const perception::Percept percept = perception.see(frame());
  keep_salient(percept.keypoints, percept.saliency, salient);
  return salient;
}

cv::Mat1b left_grey() {
  cv::Mat1b grey;
  cv::cvtColor(frame().left, grey, cv::COLOR_BGR2GRAY);
  return grey;
}

void describing(benchmark::State& state) {
  perception::OrientedKeypoints oriented(perception::OrientedSettings{});
  const std::vector<perception::Keypoint> salient = salient_keypoints();
  const cv::Mat1b grey = left_grey();
  std::vector<perception::Keypoint> described;
  for (auto _ : state) oriented.describe(grey, salient, described);
  state.counters["descriptors"] = static_cast<double>(described.size());
}

/// Of the salient keypoints, or of all of the image.
void recognition(benchmark::State& state, bool whole_image) {
  perception::Recogniser recogniser = taught();
  perception::OrientedKeypoints oriented(perception::OrientedSettings{});
  const cv::Mat1b grey = left_grey();
  std::vector<perception::Keypoint> described;
  oriented.describe(grey, whole_image ? perception::find_keypoints(grey, {}) : salient_keypoints(),
                    described);
  for (auto _ : state) benchmark::DoNotOptimize(recogniser.recognise(described).size());
  state.counters["descriptors"] = static_cast<double>(described.size());
}

}  // namespace
}  // namespace striate

int main(int argc, char** argv) {
  striate::InTurns turns(argc, argv, 5, "0.1");
  if (turns.refuse_arguments()) return 2;
  auto add = [](const char* name, const auto& function) {
    benchmark::RegisterBenchmark(name, function)->Unit(benchmark::kMillisecond);
  };
  add("stereo to recognition", striate::stereo_to_recognition);
  add("the same, with obstacles and corridor", striate::whole_cycle);
  add("seeing", [](auto& state) { striate::seeing_without(state, true); });
  add("seeing without keypoints", [](auto& state) { striate::seeing_without(state, false); });
  add("stereo 160x120, robust", striate::stereo);
  add("saliency, paper", striate::saliency);
  add("keypoints", striate::keypoints);
  add("describing the salient keypoints", striate::describing);
  add("recognition", [](auto& state) { striate::recognition(state, false); });
  add("recognition, whole image", [](auto& state) { striate::recognition(state, true); });
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
