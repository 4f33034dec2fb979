#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/imgproc.hpp>

#include "striate/perception/noise_estimate.hpp"
#include "striate/perception/perception.hpp"
#include "tests/unit/perception/obstacles_synthetic_room.hpp"

namespace striate::perception {
namespace {

/// A textured board straight ahead, seen by two eyes: one image is the other, shifted.
StereoFrame board_at(double distance_m) {
  StereoFrame frame;
  frame.focal_px = 406.0;
  frame.centre_u_px = 159.5;
  frame.centre_v_px = 119.5;
  frame.baseline_m = 0.12;
  cv::Mat1b wide(240, 480);
  for (int v = 0; v < wide.rows; ++v) {
    for (int u = 0; u < wide.cols; ++u) {
      const std::uint64_t cell = static_cast<std::uint64_t>(v / 5) * 1000 + u / 5;
      wide(v, u) = static_cast<uchar>(128.0 + 100.0 * synthetic::noise(cell));
    }
  }
  const int shift = static_cast<int>(std::lround(frame.focal_px * frame.baseline_m / distance_m));
  cv::cvtColor(wide(cv::Rect(80, 0, 320, 240)), frame.left, cv::COLOR_GRAY2BGR);
  cv::cvtColor(wide(cv::Rect(80 + shift, 0, 320, 240)), frame.right, cv::COLOR_GRAY2BGR);
  return frame;
}

TEST(Perception, NoImageGivesAnInvalidPercept) {
  Perception perception({}, {});
  const Percept percept = perception.see({});
  EXPECT_FALSE(percept.valid);
  EXPECT_TRUE(percept.columns.empty());
  EXPECT_TRUE(percept.saliency.regions.empty());
}

TEST(Perception, SeesABoardAtItsDistanceAndNothingFreeBehindIt) {
  Perception perception({}, {});
  const Percept percept = perception.see(board_at(2.0));
  ASSERT_TRUE(percept.valid);
  ASSERT_EQ(percept.columns.size(), 160U);
  EXPECT_NEAR(percept.columns[80].obstacle_m, 2.0, 0.1);
  EXPECT_LE(percept.columns[80].free_to_m, 2.0);
  ASSERT_FALSE(percept.obstacles.empty());
  EXPECT_NEAR(percept.disparity.focal_px, 203.0, 1e-9);
  EXPECT_NEAR(percept.disparity.centre_u_px, 79.5, 1e-9);
  EXPECT_EQ(percept.saliency.salience.size(), cv::Size(160, 120));
  EXPECT_NEAR(percept.light_level, 0.5, 0.05);
}

TEST(Perception, ThePaperSettingThresholdsTheDisparity) {
  PerceptionSettings settings;
  settings.stereo.mode = StereoMode::paper;
  Perception perception(settings, {});
  EXPECT_NEAR(perception.see(board_at(2.0)).columns[80].obstacle_m, 2.0, 0.2);
  EXPECT_EQ(perception.see(board_at(4.5)).columns[80].obstacle_m, kNothing_m);
}

/// The same board by a fraction of its light: contrast falls, noise stays.
StereoFrame in_little_light(StereoFrame frame, double light, double noise) {
  std::uint64_t counter = 0;
  for (cv::Mat3b* image : {&frame.left, &frame.right}) {
    for (cv::Vec3b& pixel : *image) {
      const double n = noise * (synthetic::noise(counter) + synthetic::noise(counter + 1));
      counter += 2;
      pixel = cv::Vec3b::all(cv::saturate_cast<uchar>(30.0 + light * (pixel[0] - 128.0) + n));
    }
  }
  return frame;
}

TEST(Perception, InTheDarkConfidenceFallsAndNotTheTruthOfTheDistance) {
  double brighter = 1.0;
  for (const double light : {0.5, 0.08, 0.015}) {
    Perception perception({}, {});
    const Percept percept = perception.see(in_little_light(board_at(2.0), light, 6.0));
    double confidence = 0.0;
    double promised = 0.0;
    double right = 0.0;
    for (const Column& column : percept.columns) {
      confidence += column.obstacle_confidence / 160.0;
      if (column.obstacle_confidence <= 0.5) continue;
      promised += column.obstacle_confidence;
      right += std::abs(column.obstacle_m * std::cos(column.bearing_rad) - 2.0) < 0.3;
    }
    EXPECT_GE(right, promised) << light;  // confidence says how many are right
    EXPECT_LT(confidence, brighter) << light;
    brighter = confidence;
  }
  EXPECT_LT(brighter, 0.3);
}

TEST(Perception, ABlankDoorIsBoundedByItsEdges) {
  StereoFrame frame = board_at(2.0);
  const cv::Rect door(130, 0, 60, 240);
  const cv::Rect as_right_eye_sees(door - cv::Point(24, 0));
  frame.left(door).setTo(cv::Vec3b::all(150));
  frame.right(as_right_eye_sees).setTo(cv::Vec3b::all(150));
  Perception perception({}, {});
  const Percept percept = perception.see(frame);
  for (int u = 67; u < 93; ++u) {
    const Column& column = percept.columns[static_cast<std::size_t>(u)];
    EXPECT_LE(column.free_to_m, 2.0) << u;
    EXPECT_NEAR(column.obstacle_m, 2.0, 0.1) << u;
  }
  EXPECT_LT(percept.columns[80].obstacle_confidence, percept.columns[30].obstacle_confidence);
}

TEST(Perception, OneEyeSeesSalienceButNoObstacles) {
  StereoFrame frame = board_at(2.0);
  frame.right.release();
  Perception perception({}, {});
  const Percept percept = perception.see(frame);
  EXPECT_TRUE(percept.valid);
  EXPECT_TRUE(percept.columns.empty());
  EXPECT_TRUE(percept.disparity.disparity_px.empty());
  EXPECT_EQ(percept.saliency.salience.size(), cv::Size(160, 120));
}

TEST(Perception, EyesOfDifferentSizeAreABug) {
  StereoFrame frame = board_at(2.0);
  frame.right = frame.right(cv::Rect(0, 0, 300, 240)).clone();
  Perception perception({}, {});
  EXPECT_THROW(static_cast<void>(perception.see(frame)), std::invalid_argument);
}

TEST(Perception, TheSameImagesGiveTheSamePercept) {
  Perception one({}, {});
  Perception two({}, {});
  const Percept a = one.see(board_at(1.5));
  const Percept b = two.see(board_at(1.5));
  ASSERT_EQ(a.columns.size(), b.columns.size());
  for (std::size_t i = 0; i < a.columns.size(); ++i) {
    EXPECT_EQ(a.columns[i].obstacle_m, b.columns[i].obstacle_m);
    EXPECT_EQ(a.columns[i].free_confidence, b.columns[i].free_confidence);
  }
}

TEST(Perception, SalienceComesInEveryNthImage) {
  PerceptionSettings settings;
  settings.saliency_every = 3;
  Perception perception(settings, {});
  const StereoFrame frame = board_at(2.0);
  for (int i = 0; i < 6; ++i) {
    EXPECT_EQ(perception.see(frame).saliency.salience.empty(), i % 3 != 0);
  }
}

TEST(Perception, KeypointsLieInTheWholeImageAndComeWhenAskedFor) {
  PerceptionSettings settings;
  settings.keypoints_every = 2;
  Perception perception(settings, {});
  const StereoFrame frame = board_at(2.0);
  const std::vector<Keypoint> found = perception.see(frame).keypoints;
  ASSERT_GT(found.size(), 20U);
  double rightmost = 0.0;
  for (const Keypoint& k : found) rightmost = std::max(rightmost, k.u_px);
  EXPECT_GT(rightmost, 200.0);  // the image is 320 wide, not the working size's 160
  EXPECT_TRUE(perception.see(frame).keypoints.empty());
  settings.keypoints_every = 0;
  EXPECT_TRUE(Perception(settings, {}).see(frame).keypoints.empty());
}

TEST(NoiseEstimate, FindsTheNoiseOfABlankImageAndNotItsEdges) {
  for (const double sigma : {1.0, 3.0, 8.0}) {
    cv::Mat1b grey(240, 320);
    for (int v = 0; v < grey.rows; ++v) {
      for (int u = 0; u < grey.cols; ++u) {
        double normal = 0.0;  // sum of 12 uniforms of variance 1/3
        for (int k = 0; k < 12; ++k) {
          normal += synthetic::noise((static_cast<std::uint64_t>(v) * 320 + u) * 12 + k);
        }
        const double edge = (u / 40) % 2 == 0 ? 90.0 : 150.0;
        grey(v, u) = cv::saturate_cast<uchar>(edge + sigma * normal / 2.0);
      }
    }
    EXPECT_NEAR(estimate_noise(grey), sigma, 0.15 * sigma + 0.1) << sigma;
  }
}

}  // namespace
}  // namespace striate::perception
