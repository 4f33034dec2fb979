#include <fmt/format.h>

#include <cstdlib>
#include <functional>
#include <opencv2/calib3d.hpp>

#include "perception/stereo/stereo_matcher.hpp"
#include "tests/reference/stereo_pairs.hpp"
#include "tests/reference/stereo_reference.hpp"

/// stereo_table [folder]: how good the disparities are on public pairs with ground truth, beside
/// an exact reference of the paper's method and OpenCV's matchers.
namespace striate {
namespace {

constexpr int kPaperCandidates = 150;
constexpr int kSearched = 48;  ///< of OpenCV's matchers and the robust setting: covers all pairs

using Matcher = std::function<cv::Mat1f(const cv::Mat1b&, const cv::Mat1b&)>;
struct Method {
  std::string name;
  Matcher match;
};

cv::Mat1f exact_paper(const cv::Mat1b& left, const cv::Mat1b& right) {
  cv::Mat1f result;
  reference::paper_stereo(left, right, kPaperCandidates).convertTo(result, CV_32F);
  return result;
}

Matcher ours(StereoSetting setting, int candidates) {
  StereoSettings settings;
  settings.setting = setting;
  settings.candidates = candidates;
  auto matcher = std::make_shared<StereoMatcher>(settings);
  return [matcher](const cv::Mat1b& left, const cv::Mat1b& right) {
    return matcher->match(left, right).disparity_px;
  };
}

Matcher opencv(const cv::Ptr<cv::StereoMatcher>& matcher) {
  return [matcher](const cv::Mat1b& left, const cv::Mat1b& right) {
    // OpenCV does not search the first columns: continue the pictures to the left.
    cv::Mat wide_left, wide_right;
    cv::copyMakeBorder(left, wide_left, 0, 0, kSearched, 0, cv::BORDER_REPLICATE);
    cv::copyMakeBorder(right, wide_right, 0, 0, kSearched, 0, cv::BORDER_REPLICATE);
    cv::Mat1s fixed;
    matcher->compute(wide_left, wide_right, fixed);
    cv::medianBlur(fixed, fixed, 5);
    cv::Mat1f result;
    fixed.colRange(kSearched, fixed.cols).convertTo(result, CV_32F, 1.0 / 16.0);
    result.setTo(std::numeric_limits<float>::infinity(), result < 0.0F);
    return result;
  };
}

Matcher semi_global_opencv(int mode) {
  return opencv(cv::StereoSGBM::create(0, kSearched, 3, 8 * 9, 32 * 9, 1, 63, 10, 100, 2, mode));
}

/// Another exposure and noise in the right picture: gain 1.3, sigma 6.
cv::Mat1b disturb(const cv::Mat1b& picture) {
  cv::RNG random(7);
  cv::Mat1f noise(picture.size()), result;
  random.fill(noise, cv::RNG::NORMAL, 0.0, 6.0);
  picture.convertTo(result, CV_32F, 1.3);
  result += noise;
  cv::Mat1b grey;
  result.convertTo(grey, CV_8U);
  return grey;
}

void print_table(const std::string& title, const std::vector<reference::StereoPair>& pairs,
                 const std::vector<Method>& methods, bool disturbed) {
  fmt::print("\n{}\n{:14}", title, "bad-2 %");
  for (const reference::StereoPair& pair : pairs) fmt::print(" {:>6.6}", pair.name);
  fmt::print(" |  bad-2  bad-1 density\n");
  for (const Method& method : methods) {
    fmt::print("{:14}", method.name);
    reference::StereoScore mean;
    for (const reference::StereoPair& pair : pairs) {
      const cv::Mat1b right = disturbed ? disturb(pair.right) : pair.right;
      const reference::StereoScore score =
          reference::judge(method.match(pair.left, right), pair.truth_px);
      fmt::print(" {:6.1f}", score.bad2);
      mean.bad2 += score.bad2 / static_cast<double>(pairs.size());
      mean.bad1 += score.bad1 / static_cast<double>(pairs.size());
      mean.density += score.density / static_cast<double>(pairs.size());
    }
    fmt::print(" | {:6.2f} {:6.2f} {:7.1f}\n", mean.bad2, mean.bad1, mean.density);
  }
}

}  // namespace
}  // namespace striate

int main(int argc, char** argv) {
  using namespace striate;
  const std::string folder = argc > 1 ? argv[1] : STRIATE_SHARED_DATA "/stereo";
  const auto pairs = reference::load_stereo_pairs(folder, {160, 120});
  if (pairs.empty()) {
    fmt::print(stderr, "stereo_table: no stereo pairs below {}\n", folder);
    return 2;
  }
  const std::vector<Method> methods = {
      {"paper, exact", exact_paper},
      {"paper", ours(StereoSetting::paper, kPaperCandidates)},
      {"paper, K = 48", ours(StereoSetting::paper, kSearched)},
      {"robust", ours(StereoSetting::robust, kSearched)},
      {"StereoBM 9", opencv([] {
         auto matcher = cv::StereoBM::create(kSearched, 9);
         return matcher;
       }())},
      {"SGBM", semi_global_opencv(cv::StereoSGBM::MODE_SGBM)},
      {"SGBM 3WAY", semi_global_opencv(cv::StereoSGBM::MODE_SGBM_3WAY)},
      {"SGBM HH", semi_global_opencv(cv::StereoSGBM::MODE_HH)},
  };
  print_table("160x120", pairs, methods, false);
  print_table("160x120, right picture with gain 1.3 and noise of sigma 6", pairs, methods, true);
  return 0;
}
