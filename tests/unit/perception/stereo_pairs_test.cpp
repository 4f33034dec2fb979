#include "tests/reference/stereo_pairs.hpp"

#include <gtest/gtest.h>

#include "perception/stereo/stereo_matcher.hpp"
#include "tests/reference/stereo_reference.hpp"

/// Pictures with ground truth: painted rooms, and photographs where the public data is at hand. The
/// whole table is printed by tests/evaluation/stereo_table.
namespace striate {
namespace {

std::vector<reference::StereoPair> rooms() {
  return reference::painted_stereo_pairs(3, {160, 120});
}

std::vector<reference::StereoPair> photographs() {
  std::vector<reference::StereoPair> chosen;
  for (reference::StereoPair& pair : reference::load_stereo_pairs(
           reference::shared_data(STRIATE_SHARED_DATA) + "/stereo", {160, 120})) {
    const bool wanted = pair.name == "teddy" || pair.name == "Aloe" || pair.name == "Bowling1";
    if (wanted) chosen.push_back(std::move(pair));
  }
  return chosen;
}

/// Means in %.
struct PaperScore {
  double fast_bad2 = 0.0, exact_bad2 = 0.0;
};

PaperScore paper_score(const std::vector<reference::StereoPair>& pairs) {
  StereoSettings settings;
  settings.setting = StereoSetting::paper;
  settings.candidates = 150;
  StereoMatcher stereo(settings);
  PaperScore mean;
  const auto share = 1.0 / static_cast<double>(pairs.size());
  for (const reference::StereoPair& pair : pairs) {
    cv::Mat1f plain;
    reference::paper_stereo(pair.fine_left, pair.fine_right, 150).convertTo(plain, CV_32F);
    mean.exact_bad2 += share * reference::judge(plain, pair.truth_px).bad2;
    const DisparityMap map = stereo.match(pair.fine_left, pair.fine_right);
    const reference::StereoScore score = reference::judge(map.disparity_px, pair.truth_px);
    mean.fast_bad2 += share * score.bad2;
    EXPECT_EQ(score.density, 100.0) << "the paper rejects nothing";
  }
  EXPECT_LT(std::abs(mean.fast_bad2 - mean.exact_bad2), 1.5)
      << "fast " << mean.fast_bad2 << ", exact " << mean.exact_bad2;
  return mean;
}

TEST(StereoPairs, ThePaperSettingIsAsGoodAsItsExactReference) {
  EXPECT_LT(paper_score(rooms()).fast_bad2, 20.0);
  const auto public_pairs = photographs();
  if (public_pairs.empty()) return;  // they are a second opinion
  EXPECT_LT(paper_score(public_pairs).fast_bad2, 20.0);
}

TEST(StereoPairs, TheRobustSettingHalvesThePapersErrorsAndKeepsMostPixels) {
  std::vector<reference::StereoPair> pairs = rooms();
  for (reference::StereoPair& pair : photographs()) pairs.push_back(std::move(pair));
  StereoSettings paper;
  paper.setting = StereoSetting::paper;
  StereoMatcher by_paper(paper), robust{StereoSettings{}};
  for (const reference::StereoPair& pair : pairs) {
    const reference::StereoScore before =
        reference::judge(by_paper.match(pair.left, pair.right).disparity_px, pair.truth_px);
    const reference::StereoScore after =
        reference::judge(robust.match(pair.fine_left, pair.fine_right).disparity_px, pair.truth_px);
    EXPECT_LT(after.bad2, 0.5 * before.bad2) << pair.name << ", by the paper " << before.bad2;
    EXPECT_GT(after.density, 75.0) << pair.name;
  }
}

}  // namespace
}  // namespace striate
