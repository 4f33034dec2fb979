#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "striate/base/files.hpp"
#include "striate/base/user_error.hpp"
#include "striate/evaluation/evaluation.hpp"
#include "striate/evaluation/plot.hpp"
#include "striate/evaluation/report.hpp"
#include "striate/evaluation/stereo_methods.hpp"

/// `striate eval stereo`: disparities against ground truth, ours and OpenCV's in one run.
namespace striate::evaluation {
namespace {

/// Of a working image: 3 rows of a camera of 640 px, when brought to 160
constexpr double kRowsOff = 0.75;

struct Tables {
  Report means{"Mean over all pairs; bad: % of the matched pixels that both eyes see",
               {"method", "size", "pictures", "bad-2 %", "bad-1 %", "density %"}};
  Report pairs{"", {"pair", "method", "size", "pictures", "bad-2 %", "bad-1 %", "density %"}};
  Report calibration{"Robust mode: what the confidence says and how often it is right within 1 px",
                     {"size", "pictures", "confidence", "pixels", "mean confidence %", "right %"}};
  BarPlot bars{"Stereo: wrong by more than 2 px", "bad-2, % of matched pixels", {}, {}};
  Plot promise{"Calibration of the robust mode", "confidence, %", "right within 1 px, %", {}};
};

std::vector<std::string> cells(std::vector<std::string> names, const StereoScore& score) {
  for (const double value : {score.bad2, score.bad1, score.density}) {
    names.push_back(fmt::format("{:.2f}", value));
  }
  return names;
}

void add_calibration(const Calibration& calibration, const std::string& size,
                     const std::string& state, Tables& tables) {
  PlotCurve curve{fmt::format("{}, {}", size, state), {}, {}};
  auto add = [&](const std::string& range, const Calibration::Bin& bin) {
    const double promised = 100.0 * bin.confidence_sum / std::max(1, bin.count);
    const double right = 100.0 * bin.right / std::max(1, bin.count);
    tables.calibration.add_row({size, state, range, std::to_string(bin.count),
                                fmt::format("{:.1f}", promised), fmt::format("{:.1f}", right)});
    return std::pair{promised, right};
  };
  for (int k = 0; k < Calibration::kBins; ++k) {
    const Calibration::Bin& bin = calibration.bins()[static_cast<std::size_t>(k)];
    if (bin.count == 0) continue;
    const double tenth = 1.0 / Calibration::kBins;
    const auto [promised, right] =
        add(fmt::format("{:.1f}-{:.1f}", k * tenth, (k + 1) * tenth), bin);
    curve.x.push_back(promised);
    curve.y.push_back(right);
  }
  add("0.87-0.93", calibration.ninety());
  tables.promise.curves.push_back(std::move(curve));
}

struct EyeState {
  std::string name;
  EyeChange change;
};

/// All methods at one size and with each state of the right eye.
void measure_size(const StereoFolders& folders, cv::Size size, Tables& tables) {
  std::vector<StereoPair> pairs;
  for (const StereoFolder& folder : folders.pairs) pairs.push_back(read_stereo_pair(folder, size));
  const std::string size_text = fmt::format("{}x{}", size.width, size.height);
  const int searched = disparities_to_search(pairs);
  const std::vector<StereoMethod> methods = stereo_methods(size.width, searched);
  fmt::print("{}: {} pairs, {} disparities searched\n", size_text, pairs.size(), searched);
  tables.bars.labels.clear();
  for (const StereoMethod& method : methods) tables.bars.labels.push_back(method.name);
  const std::vector<EyeState> states = {
      {"clean", nullptr}, {"disturbed", disturb}, {"rows off", lowered_by(kRowsOff)}};
  for (const auto& [state, change] : states) {
    BarPlot::Series series{fmt::format("{}, {}", size_text, state), {}};
    for (const StereoMethod& method : methods) {
      const StereoResult result = measure(method, pairs, change);
      tables.means.add_row(cells({method.name, size_text, state}, result.mean));
      for (std::size_t k = 0; k < pairs.size(); ++k) {
        tables.pairs.add_row(
            cells({pairs[k].name, method.name, size_text, state}, result.of_pairs[k]));
      }
      if (method.name == "robust") add_calibration(result.calibration, size_text, state, tables);
      series.values.push_back(result.mean.bad2);
    }
    tables.bars.series.push_back(std::move(series));
  }
}

}  // namespace

int evaluate_stereo(const EvalOptions& options) {
  const StereoFolders folders = find_stereo_folders(options.folder);
  for (const std::string& folder : folders.skipped) {
    fmt::print("{}: skipped, no ground truth\n", folder);
  }
  if (folders.pairs.empty()) {
    throw UserError(options.folder +
                    ": no stereo pair with ground truth in it or below. A pair is a folder with "
                    "imL.png, imR.png, groundtruth.png (4 per px), nonocc.png; or view1.png, "
                    "view5.png, disp1.png, disp5.png (3 per px); or left.png, right.png, "
                    "disparity.pfm");
  }
  Tables tables;
  for (const cv::Size size : {cv::Size(160, 120), cv::Size(320, 240)}) {
    measure_size(folders, size, tables);
  }
  tables.promise.curves.push_back({"promise kept", {0.0, 100.0}, {0.0, 100.0}});
  fmt::print(
      "\n{}\npaper (K): the paper mode with the others' disparities\ndisturbed: the right "
      "image with gain 1.3 and noise of sigma 6\nrows off: the right image {} rows lower\n\n{}",
      tables.means.text(), kRowsOff, tables.calibration.text());
  write_file(options.out + "/stereo.csv", tables.means.csv());
  write_file(options.out + "/stereo_pairs.csv", tables.pairs.csv());
  write_file(options.out + "/stereo_calibration.csv", tables.calibration.csv());
  write_file(options.out + "/stereo.svg", tables.bars.svg());
  write_file(options.out + "/stereo_calibration.svg", tables.promise.svg());
  fmt::print(
      "\nwritten: {}/stereo.csv, stereo_pairs.csv, stereo_calibration.csv, stereo.svg, "
      "stereo_calibration.svg\n",
      options.out);
  return 0;
}

}  // namespace striate::evaluation
