#include "tests/reference/stereo_pairs.hpp"

#include <gtest/gtest.h>

#include "perception/stereo/stereo_matcher.hpp"
#include "tests/reference/stereo_reference.hpp"

/// Real pictures with ground truth; skipped where the public data are not at hand. The whole table
/// is printed by tests/evaluation/stereo_table.
namespace striate {
namespace {

std::vector<reference::StereoPair> some_pairs() {
  std::vector<reference::StereoPair> chosen;
  for (reference::StereoPair& pair : reference::load_stereo_pairs(
           reference::shared_data(STRIATE_SHARED_DATA) + "/stereo", {160, 120})) {
    const bool wanted = pair.name == "teddy" || pair.name == "Aloe" || pair.name == "Bowling1";
    if (wanted) chosen.push_back(std::move(pair));
  }
  return chosen;
}

TEST(StereoPairs, ThePaperSettingIsAsGoodAsItsExactReference) {
  const auto pairs = some_pairs();
  if (pairs.empty()) GTEST_SKIP() << "no stereo pairs below " STRIATE_SHARED_DATA;
  StereoSettings settings;
  settings.setting = StereoSetting::paper;
  settings.candidates = 150;
  StereoMatcher stereo(settings);
  double fast = 0.0, exact = 0.0;
  for (const reference::StereoPair& pair : pairs) {
    cv::Mat1f plain;
    reference::paper_stereo(pair.fine_left, pair.fine_right, 150).convertTo(plain, CV_32F);
    exact += reference::judge(plain, pair.truth_px).bad2 / static_cast<double>(pairs.size());
    const DisparityMap map = stereo.match(pair.fine_left, pair.fine_right);
    const reference::StereoScore score = reference::judge(map.disparity_px, pair.truth_px);
    fast += score.bad2 / static_cast<double>(pairs.size());
    EXPECT_EQ(score.density, 100.0) << "the paper rejects nothing";
  }
  EXPECT_LT(std::abs(fast - exact), 1.5) << "bad-2 in %: fast " << fast << ", exact " << exact;
  EXPECT_LT(fast, 20.0);
}

TEST(StereoPairs, TheRobustSettingHalvesThePapersErrorsAndKeepsMostPixels) {
  const auto pairs = some_pairs();
  if (pairs.empty()) GTEST_SKIP() << "no stereo pairs below " STRIATE_SHARED_DATA;
  StereoSettings paper;
  paper.setting = StereoSetting::paper;
  StereoMatcher by_paper(paper), robust{StereoSettings{}};
  for (const reference::StereoPair& pair : pairs) {
    const reference::StereoScore before =
        reference::judge(by_paper.match(pair.left, pair.right).disparity_px, pair.truth_px);
    const reference::StereoScore after =
        reference::judge(robust.match(pair.fine_left, pair.fine_right).disparity_px, pair.truth_px);
    EXPECT_LT(after.bad2, 0.5 * before.bad2) << pair.name;
    EXPECT_GT(after.density, 75.0) << pair.name;
  }
}

}  // namespace
}  // namespace striate
