#include "striate/agent/teaching/image_view.hpp"

#include <gtest/gtest.h>

#include <map>
#include <opencv2/imgproc.hpp>

#include "striate/perception/recognition/landmark_view.hpp"

namespace striate::agent {
namespace {

cv::Mat3b speckled(cv::Size size) {
  cv::RNG random(4);
  cv::Mat3b fine(size), coarse(size.height / 12, size.width / 12);
  random.fill(fine, cv::RNG::UNIFORM, 0, 255);
  random.fill(coarse, cv::RNG::UNIFORM, 0, 255);
  cv::resize(coarse, coarse, size, 0.0, 0.0, cv::INTER_CUBIC);
  cv::Mat3b both;
  cv::GaussianBlur(fine, fine, {}, 0.9);
  cv::addWeighted(fine, 0.8, coarse, 0.3, 0.0, both);
  return both;
}

TEST(ImageView, KeepsTheStrongestKeypointsOfEachSize) {
  const cv::Mat3b picture = speckled({480, 360});
  cv::Mat1b grey;
  cv::cvtColor(picture, grey, cv::COLOR_BGR2GRAY);
  std::map<float, int> there, kept;
  for (const perception::Keypoint& point : keypoints_to_learn(grey)) {
    ++there[static_cast<float>(point.wavelength_px)];
  }
  memory::LongTermSettings settings;
  settings.most_keypoints = 80;
  const memory::StoredView view = view_of_image(picture, settings, {});
  ASSERT_EQ(view.keypoints.size(), 80U);
  for (const perception::ViewKeypoint& point : view.keypoints) ++kept[point.size_px];
  const int share = 80 / static_cast<int>(there.size());
  for (const auto& [size_px, count] : there) {
    EXPECT_GE(kept[size_px], std::min(count, share)) << "of " << size_px << " px";
  }
}

TEST(ImageView, IsNoLargerThanAPictureOfTheRobotsCamera) {
  const memory::StoredView view = view_of_image(speckled({1500, 900}), {}, {});
  EXPECT_EQ(view.width_px, perception::kLongestView_px);
  EXPECT_EQ(view.height_px, 384);
  EXPECT_LE(view.keypoints.size(), 400U);
}

}  // namespace
}  // namespace striate::agent
