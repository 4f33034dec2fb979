#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <hwy/targets.h>

#include <cstdlib>
#include <cstring>
#include <map>
#include <opencv2/features2d.hpp>

#include "striate/perception/matching/hamming_search.hpp"
#include "striate/perception/recognition/oriented_keypoints.hpp"
#include "tests/benchmarks/in_turns.hpp"
#include "tests/reference/hamming_reference.hpp"
#include "tests/reference/test_images.hpp"

/// matching_benchmark: 500 descriptors against 100,000 and 1,000,000 stored ones, distance below
/// 48, on one core; all instruction sets and OpenCV's brute-force matcher in turns. Checks first
/// that both find the same.
namespace striate {
namespace {

constexpr std::size_t kQueries = 500;
constexpr std::uint32_t kLimit = 48;

/// OpenCV takes at most 2^18 rows in one matrix, but several matrices.
constexpr int kRowsOfPart = 250'000;

struct Data {
  std::vector<perception::Descriptor> queries, stored;
  perception::DescriptorStore store;
  cv::Mat query_rows;
  std::vector<cv::Mat> stored_parts;
};

cv::Mat rows_of(const std::vector<perception::Descriptor>& descriptors) {
  cv::Mat rows(static_cast<int>(descriptors.size()), 32, CV_8U);
  std::memcpy(rows.data, descriptors.data(), descriptors.size() * 32);
  return rows;
}

/// Every other query has a counterpart at distance 30, as when an object is seen again.
Data complete(std::vector<perception::Descriptor> stored) {
  Data data;
  data.stored = std::move(stored);
  data.queries = reference::random_descriptors(kQueries, 77);
  for (std::size_t q = 0; q < kQueries; ++q) {
    const perception::Descriptor& twin = data.stored[q * 151 % data.stored.size()];
    data.queries[q] = reference::disturbed(twin, q % 2 == 0 ? 30 : 90, static_cast<unsigned>(q));
  }
  data.store.append(data.stored);
  data.query_rows = rows_of(data.queries);
  const cv::Mat rows = rows_of(data.stored);
  for (int r = 0; r < rows.rows; r += kRowsOfPart) {
    data.stored_parts.push_back(rows.rowRange(r, std::min(rows.rows, r + kRowsOfPart)));
  }
  return data;
}

/// Striate's own descriptors of keypoints in made images: their bits depend on each other as real
/// ones do.
std::vector<perception::Descriptor> of_keypoints(std::size_t count) {
  std::vector<perception::Descriptor> result;
  perception::OrientedSettings settings;
  settings.keypoints = {};
  settings.keypoints.threshold = 0.0;
  perception::OrientedKeypoints oriented(settings);
  for (int seed = 1; result.size() < count; ++seed) {
    for (const perception::Keypoint& point : oriented(reference::texture({640, 480}, seed))) {
      if (result.size() < count) result.push_back(point.descriptor);
    }
  }
  return result;
}

std::uint32_t stored_index(const cv::DMatch& match) {
  return static_cast<std::uint32_t>(match.imgIdx * kRowsOfPart + match.trainIdx);
}

std::vector<std::vector<cv::DMatch>> opencv_below(const Data& data) {
  std::vector<std::vector<cv::DMatch>> matches;
  cv::BFMatcher matcher(cv::NORM_HAMMING);
  matcher.add(data.stored_parts);
  matcher.radiusMatch(data.query_rows, matches, static_cast<float>(kLimit - 1));  // inclusive
  return matches;
}

std::vector<cv::DMatch> opencv_nearest(const Data& data) {
  std::vector<cv::DMatch> matches;
  cv::BFMatcher matcher(cv::NORM_HAMMING);
  matcher.add(data.stored_parts);
  matcher.match(data.query_rows, matches);
  return matches;
}

/// Both matchers must find the same pairs, and the same nearest below the limit.
bool same_answers(const Data& data) {
  perception::HammingSearch search;
  std::vector<perception::Match> theirs;
  for (auto& of_query : opencv_below(data)) {
    std::ranges::sort(of_query, {}, stored_index);
    for (const cv::DMatch& match : of_query) {
      theirs.push_back({static_cast<std::uint32_t>(match.queryIdx), stored_index(match),
                        static_cast<std::uint32_t>(match.distance)});
    }
  }
  if (!std::ranges::equal(search.below(data.queries, data.store, kLimit), theirs)) return false;
  const auto nearest = search.nearest_two(data.queries, data.store, kLimit);
  for (const cv::DMatch& match : opencv_nearest(data)) {
    const perception::NearestTwo& ours = nearest[static_cast<std::size_t>(match.queryIdx)];
    const auto bits = static_cast<std::uint32_t>(match.distance);
    if (bits < kLimit ? ours.first_bits != bits : ours.first != perception::NearestTwo::kNone)
      return false;
  }
  return true;
}

void restrict_to(std::int64_t target) {
  hwy::SetSupportedTargetsForTest(target);
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

/// How many times longer OpenCV takes for the same answer.
void print_gains(const std::map<std::string, double>& cpu_ms) {
  fmt::print("\n{:44} {:>9} {:>14}\n", "median CPU time", "ms", "OpenCV / it");
  for (const auto& [name, ms] : cpu_ms) {
    const auto yardstick = cpu_ms.find(name.substr(0, name.rfind('/')) + "/OpenCV");
    if (yardstick == cpu_ms.end()) continue;
    fmt::print("{:44} {:9.2f} {:14.1f}\n", name, ms, yardstick->second / ms);
  }
}

void add_benchmarks(const std::string& what, const Data& data) {
  auto add = [](const std::string& name, auto function) {
    benchmark::RegisterBenchmark(name.c_str(), [function](benchmark::State& state) {
      for (auto _ : state) benchmark::DoNotOptimize(function());
    })->Unit(benchmark::kMillisecond);
  };
  for (const std::int64_t target : {HWY_AVX3_DL, HWY_AVX2, HWY_SSE4, HWY_NEON}) {
    restrict_to(0);
    if ((hwy::SupportedTargets() & target) == 0) continue;
    const std::string name = hwy::TargetName(target);
    auto search = std::make_shared<perception::HammingSearch>();
    add(what + ", all below 48/" + name, [&data, search, target] {
      restrict_to(target);
      return search->below(data.queries, data.store, kLimit).size();
    });
    add(what + ", nearest below 48/" + name, [&data, search, target] {
      restrict_to(target);
      return search->nearest_two(data.queries, data.store, kLimit).size();
    });
  }
  add(what + ", all below 48/OpenCV", [&data] { return opencv_below(data).size(); });
  add(what + ", nearest below 48/OpenCV", [&data] { return opencv_nearest(data).size(); });
}

}  // namespace
}  // namespace striate

int main(int argc, char** argv) {
  striate::InTurns turns(argc, argv, 5, "0.02");
  if (turns.refuse_arguments()) return 2;
  using striate::reference::random_descriptors;
  const std::map<std::string, striate::Data> all = {
      {"100,000 random", striate::complete(random_descriptors(100'000, 1))},
      {"1,000,000 random", striate::complete(random_descriptors(1'000'000, 2))},
      {"100,000 of keypoints", striate::complete(striate::of_keypoints(100'000))},
  };
  for (const auto& [what, data] : all) {
    if (!striate::same_answers(data)) {
      fmt::print(stderr, "matching_benchmark: {}: the answers differ from OpenCV's\n", what);
      return 1;
    }
    striate::add_benchmarks(what, data);
  }
  striate::Medians medians;
  benchmark::RunSpecifiedBenchmarks(&medians);
  striate::print_gains(medians.cpu_time());
  return 0;
}
