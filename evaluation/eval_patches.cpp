#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "striate/base/files.hpp"
#include "striate/evaluation/evaluation.hpp"
#include "striate/evaluation/patch_layouts.hpp"
#include "striate/evaluation/plot.hpp"
#include "striate/evaluation/report.hpp"
#include "striate/evaluation/striate_patch_methods.hpp"

namespace striate::evaluation {
namespace {

/// On which the best size is chosen: its rates are known to 1 %
constexpr std::size_t kSampledPairs = 4000;

/// Every so many pairs with only the patches they need.
PatchSet sample_of(const PatchSet& set) {
  const std::size_t step = std::max<std::size_t>(1, set.pairs.size() / kSampledPairs);
  PatchSet sample;
  std::map<int, int> numbers;
  auto taken = [&](int number) {
    if (!numbers.contains(number)) numbers[number] = sample.add(set.patch(number));
    return numbers[number];
  };
  for (std::size_t p = 0; p < set.pairs.size(); p += step) {
    const int first = taken(set.pairs[p].first), second = taken(set.pairs[p].second);
    sample.pairs.push_back({first, second, set.pairs[p].same});
  }
  return sample;
}

double best_size_px(const PatchSet& sample, const PatchMethod& method) {
  double best_px = method.sizes_px.front(), lowest = 2.0;
  for (const double size_px : method.sizes_px) {
    const double rate =
        false_positive_rate(sample.pairs, pair_distances(sample, method, size_px), 0.95);
    if (rate < lowest) lowest = rate, best_px = size_px;
  }
  return best_px;
}

PlotCurve roc(const std::string& name, const std::vector<PatchPair>& pairs,
              const std::vector<float>& distances) {
  PlotCurve curve{name, {}, {}};
  for (int percent = 1; percent <= 100; ++percent) {
    const double rate = 100.0 * false_positive_rate(pairs, distances, percent / 100.0);
    if (rate > 50.0) break;
    curve.x.push_back(rate);
    curve.y.push_back(percent);
  }
  return curve;
}

}  // namespace

int evaluate_patches(const EvalOptions& options) {
  const PatchSet set = load_patches(options.folder, {});
  const auto same = std::ranges::count(set.pairs, true, &PatchPair::same);
  const auto all = static_cast<std::ptrdiff_t>(set.pairs.size());
  Report report(
      fmt::format("{} true and {} false patch pairs of {}", same, all - same, options.folder),
      {"descriptor", "size px", "false % at 95 % recall", "at 80 %"});
  Plot plot{
      "Receiver operating characteristic", "false pairs accepted, %", "true pairs found, %", {}};
  std::vector<PatchMethod> methods = striate_patch_methods();
  for (PatchMethod& method : opencv_patch_methods()) methods.push_back(std::move(method));
  const PatchSet sample = sample_of(set);
  for (const PatchMethod& method : methods) {
    const double size_px = best_size_px(sample, method);
    const std::vector<float> distances = pair_distances(set, method, size_px);
    report.add_row({method.name, fmt::format("{:.1f}", size_px),
                    fmt::format("{:.2f}", 100.0 * false_positive_rate(set.pairs, distances, 0.95)),
                    fmt::format("{:.3f}", 100.0 * false_positive_rate(set.pairs, distances, 0.8))});
    plot.curves.push_back(roc(method.name, set.pairs, distances));
  }
  fmt::print("{}", report.text());
  write_file(options.out + "/patches.csv", report.csv());
  write_file(options.out + "/patches.svg", plot.svg());
  return 0;
}

}  // namespace striate::evaluation
