#include <gtest/gtest.h>

#include "striate/evaluation/odometry/rival_features.hpp"
#include "tests/reference/test_images.hpp"

namespace striate::evaluation {
namespace {

TEST(OdometryMethods, ADarkPictureHasNoFeaturesAndTheNextOneHasSome) {
  const cv::Mat1b dark(120, 160, std::uint8_t{0});
  const cv::Mat1b grainy = reference::with_noise(cv::Mat1b(120, 160, std::uint8_t{128}), 40.0, 1);
  for (const OdometryMethod& method : odometry_methods()) {
    perception::FeatureSet features;
    for (const bool light : {false, true, false}) {
      method.source(light ? grainy : dark, 100, features);
      EXPECT_EQ(features.size() > 0, light) << method.name;
      EXPECT_EQ(features.descriptors.size(),
                features.size() * static_cast<std::size_t>(features.bytes))
          << method.name;
    }
  }
}

}  // namespace
}  // namespace striate::evaluation
