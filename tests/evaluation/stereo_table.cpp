#include <fmt/format.h>

#include "striate/evaluation/stereo_methods.hpp"
#include "tests/reference/stereo_pairs.hpp"
#include "tests/reference/stereo_reference.hpp"

/// stereo_table [folder]: as `striate eval stereo` at 160x120, pair by pair, and with the exact
/// reference of the paper's method.
namespace striate {
namespace {

evaluation::StereoMethod exact_paper() {
  return {
      "paper, exact",
      [](const cv::Mat& left, const cv::Mat& right) {
        constexpr int kPaperCandidates = 150;
        perception::DisparityMap map;
        reference::paper_stereo(left, right, kPaperCandidates).convertTo(map.disparity_px, CV_32F);
        map.confidence = cv::Mat1f(left.size(), 1.0F);
        return map;
      },
      true};
}

void print_table(const std::string& title, const std::vector<evaluation::StereoPair>& pairs,
                 const std::vector<evaluation::StereoMethod>& methods,
                 const evaluation::EyeChange& change = nullptr) {
  fmt::print("\n{}\n{:18}", title, "bad-2 %");
  for (const evaluation::StereoPair& pair : pairs) fmt::print(" {:>6.6}", pair.name);
  fmt::print(" |  bad-2  bad-1 density\n");
  for (const evaluation::StereoMethod& method : methods) {
    const evaluation::StereoResult result = evaluation::measure(method, pairs, change);
    fmt::print("{:18}", method.name);
    for (const evaluation::StereoScore& score : result.of_pairs) fmt::print(" {:6.1f}", score.bad2);
    fmt::print(" | {:6.2f} {:6.2f} {:7.1f}\n", result.mean.bad2, result.mean.bad1,
               result.mean.density);
  }
}

}  // namespace
}  // namespace striate

int main(int argc, char** argv) {
  using namespace striate;
  const std::string folder =
      argc > 1 ? argv[1] : reference::shared_data(STRIATE_SHARED_DATA) + "/stereo";
  const auto pairs = reference::load_stereo_pairs(folder, {160, 120});
  if (pairs.empty()) {
    fmt::print(stderr, "stereo_table: no stereo pairs below {}\n", folder);
    return 2;
  }
  std::vector<evaluation::StereoMethod> methods =
      evaluation::stereo_methods(160, evaluation::disparities_to_search(pairs));
  methods.insert(methods.begin(), exact_paper());
  print_table("160x120", pairs, methods);
  print_table("160x120, right image with gain 1.3 and noise of sigma 6", pairs, methods,
              evaluation::disturb);
  for (const double rows : {0.3, 0.75, 1.1}) {
    print_table(fmt::format("160x120, right image {} rows lower", rows), pairs, methods,
                evaluation::lowered_by(rows));
  }
  return 0;
}
