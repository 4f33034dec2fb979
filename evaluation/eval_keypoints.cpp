#include <fmt/format.h>

#include <opencv2/core/utility.hpp>

#include "striate/base/files.hpp"
#include "striate/evaluation/evaluation.hpp"
#include "striate/evaluation/homography_sequence.hpp"
#include "striate/evaluation/keypoint_methods.hpp"
#include "striate/evaluation/plot.hpp"
#include "striate/evaluation/repeatability.hpp"
#include "striate/evaluation/report.hpp"

namespace striate::evaluation {
namespace {

/// Which so many strongest keypoints, and how near they must come again.
struct Condition {
  int most;
  double tolerance_px;
};
/// See tests/evaluation/README.md, keypoints
constexpr Condition kConditions[] = {{500, 1.5}, {500, 2.5}, {1000, 1.5}, {1000, 2.5}};
constexpr int kMost = 1000;  ///< the larger number of kConditions

/// shares[condition][method]: mean over the pairs of one sequence, or over sequences.
using Shares = std::vector<std::vector<double>>;

std::vector<cv::Point2d> first_of(const std::vector<cv::Point2d>& places, int most) {
  const auto count = std::min(places.size(), static_cast<std::size_t>(most));
  return {places.begin(), places.begin() + static_cast<std::ptrdiff_t>(count)};
}

class KeypointEvaluation {
 public:
  KeypointEvaluation()
      : methods_(keypoint_methods()),
        details_("", {"sequence", "picture", "method", "keypoints", "tolerance_px", "common",
                      "repeated", "share"}) {}

  void take(const HomographySequence& sequence) {
    Shares shares(std::size(kConditions), std::vector<double>(methods_.size(), 0.0));
    for (std::size_t m = 0; m < methods_.size(); ++m) {
      std::vector<std::vector<cv::Point2d>> found;
      for (const cv::Mat1b& image : sequence.pictures) {
        found.push_back(methods_[m].find(image, kMost));
      }
      for (std::size_t c = 0; c < std::size(kConditions); ++c) {
        shares[c][m] = compare(sequence, found, kConditions[c], methods_[m].name);
      }
    }
    names_.push_back(sequence.name);
    shares_.push_back(shares);
  }

  void print_and_write(const std::string& out) const {
    BarPlot plot{"Repeatability of keypoints, mean of all sequences", "% repeated", {}, {}};
    for (const KeypointMethod& method : methods_) plot.series.push_back({method.name, {}});
    for (std::size_t c = 0; c < std::size(kConditions); ++c) {
      const Condition& condition = kConditions[c];
      Report table(fmt::format("\nRepeatability in %: the strongest {} keypoints, within {} px",
                               condition.most, condition.tolerance_px),
                   header());
      std::vector<double> sum(methods_.size(), 0.0);
      for (std::size_t s = 0; s < names_.size(); ++s) {
        table.add_row(row(names_[s], shares_[s][c]));
        for (std::size_t m = 0; m < methods_.size(); ++m) sum[m] += shares_[s][c][m];
      }
      for (double& value : sum) value /= static_cast<double>(names_.size());
      table.add_row(row("all", sum));
      fmt::print("{}", table.text());
      plot.labels.push_back(fmt::format("{} / {} px", condition.most, condition.tolerance_px));
      for (std::size_t m = 0; m < methods_.size(); ++m) {
        plot.series[m].values.push_back(100.0 * sum[m]);
      }
    }
    write_file(out + "/keypoints.csv", details_.csv());
    write_file(out + "/keypoints.svg", plot.svg());
    fmt::print("\nwritten: {0}/keypoints.csv, {0}/keypoints.svg\n", out);
  }

 private:
  double compare(const HomographySequence& sequence,
                 const std::vector<std::vector<cv::Point2d>>& found, const Condition& condition,
                 const std::string& method) {
    double sum = 0.0;
    for (std::size_t k = 0; k < sequence.to.size(); ++k) {
      const ImagePair pair{sequence.pictures[0].size(), sequence.pictures[k + 1].size(),
                           sequence.to[k]};
      const Repeatability result =
          repeatability(first_of(found[0], condition.most), first_of(found[k + 1], condition.most),
                        pair, condition.tolerance_px);
      details_.add_row({sequence.name, fmt::format("{}", k + 2), method,
                        fmt::format("{}", condition.most),
                        fmt::format("{}", condition.tolerance_px), fmt::format("{}", result.common),
                        fmt::format("{}", result.repeated), fmt::format("{:.4f}", result.share())});
      sum += result.share();
    }
    return sum / static_cast<double>(sequence.to.size());
  }

  [[nodiscard]] std::vector<std::string> header() const {
    std::vector<std::string> cells = {"sequence"};
    for (const KeypointMethod& method : methods_) cells.push_back(method.name);
    return cells;
  }

  static std::vector<std::string> row(const std::string& name, const std::vector<double>& shares) {
    std::vector<std::string> cells = {name};
    for (const double share : shares) cells.push_back(fmt::format("{:.1f}", 100.0 * share));
    return cells;
  }

  std::vector<KeypointMethod> methods_;
  Report details_;
  std::vector<std::string> names_;
  std::vector<Shares> shares_;  ///< one a sequence
};

}  // namespace

int evaluate_keypoints(const EvalOptions& options) {
  const auto folders = find_homography_sequences(options.folder);
  check_writable(options.out + "/keypoints.csv");
  KeypointEvaluation evaluation;
  for (const auto& folder : folders) evaluation.take(read_homography_sequence(folder));
  evaluation.print_and_write(options.out);
  return 0;
}

}  // namespace striate::evaluation
