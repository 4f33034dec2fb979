#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <opencv2/features2d.hpp>

#include "striate/perception/recognition/oriented_keypoints.hpp"
#include "tests/benchmarks/one_image.hpp"

/// descriptor_benchmark [PICTURE]: Striate's own descriptor of given frames at 640x480 beside ORB's
/// and BRISK's, and keypoints with descriptors; one core, methods in turns, ratios to ORB. Without
/// an image a texture made by rule is used.
namespace striate {
namespace {

constexpr int kFrames = 300;
const char* const kYardstick = "ORB describes 300";

/// The strongest keypoints of one scale, as the robot has them, or of many.
std::vector<perception::Keypoint> some_keypoints(const cv::Mat1b& image, int scales) {
  perception::KeypointSettings settings;
  settings.scales = scales;
  settings.most = kFrames;
  return perception::find_keypoints(image, settings);
}

void describe(benchmark::State& state, const cv::Mat1b& image, int scales) {
  perception::OrientedKeypoints oriented(perception::OrientedSettings{});
  const std::vector<perception::Keypoint> found = some_keypoints(image, scales);
  std::vector<perception::Keypoint> described;
  for (auto _ : state) {
    oriented.describe(image, found, described);
    benchmark::DoNotOptimize(described.data());
  }
  state.counters["described"] = static_cast<double>(described.size());
}

/// The same frames, angles as given.
void opencv_describes(benchmark::State& state, const cv::Mat1b& image,
                      const cv::Ptr<cv::Feature2D>& method) {
  std::vector<cv::KeyPoint> points;
  for (const perception::Keypoint& point : some_keypoints(image, 1)) {
    points.emplace_back(static_cast<float>(point.u_px), static_cast<float>(point.v_px), 31.0F, 0.0F,
                        1.0F, 0);
  }
  cv::Mat rows;
  for (auto _ : state) {
    std::vector<cv::KeyPoint> of_this_run = points;
    method->compute(image, of_this_run, rows);
    benchmark::DoNotOptimize(rows.data);
  }
  state.counters["described"] = rows.rows;
}

void find_and_describe(benchmark::State& state, const cv::Mat1b& image, int scales) {
  perception::OrientedSettings settings;
  if (scales == 1) settings.keypoints = {};
  settings.keypoints.most = 500;
  perception::OrientedKeypoints oriented(settings);
  std::vector<perception::Keypoint> found;
  for (auto _ : state) {
    oriented.find(image, found);
    benchmark::DoNotOptimize(found.data());
  }
  state.counters["described"] = static_cast<double>(found.size());
}

void opencv_finds(benchmark::State& state, const cv::Mat1b& image,
                  const cv::Ptr<cv::Feature2D>& method) {
  std::vector<cv::KeyPoint> points;
  cv::Mat rows;
  for (auto _ : state) {
    method->detectAndCompute(image, cv::noArray(), points, rows);
    benchmark::DoNotOptimize(rows.data);
  }
  state.counters["described"] = rows.rows;
}

void register_all(const cv::Mat1b& image) {
  auto add = [&](const char* name, const auto& function, const auto& what) {
    benchmark::RegisterBenchmark(name, [=](auto& state) {
      function(state, image, what);
    })->Unit(benchmark::kMillisecond);
  };
  const cv::Ptr<cv::Feature2D> orb = cv::ORB::create(500), brisk = cv::BRISK::create();
  add("Striate describes 300 of lambda = 8", describe, 1);
  add("Striate describes 300 of 5 scales", describe, 5);
  add(kYardstick, opencv_describes, orb);
  add("BRISK describes 300", opencv_describes, brisk);
  add("Striate finds and describes 500, lambda = 8", find_and_describe, 1);
  add("Striate finds and describes 500, 9 scales", find_and_describe, 9);
  add("ORB finds and describes 500", opencv_finds, orb);
  add("BRISK finds and describes", opencv_finds, brisk);
}

}  // namespace
}  // namespace striate

int main(int argc, char** argv) {
  striate::InTurns turns(argc, argv, 9, "0.05");
  return striate::run_on_one_image(turns, "descriptor_benchmark", striate::register_all,
                                   striate::kYardstick);
}
