#include "striate/platform/remote/stereo_pairing.hpp"

#include <gtest/gtest.h>

namespace striate::remote {
namespace {

using namespace std::chrono_literals;

EyeImage at(Duration stamp) {
  return {stamp.count(), cv::Mat3b()};
}

TEST(StereoPairing, PairsNearestStampsInAnyOrder) {
  StereoPairing pairing(20ms);
  EXPECT_FALSE(pairing.add_right(at(103ms)));
  EXPECT_FALSE(pairing.add_right(at(203ms)));
  const auto second = pairing.add_left(at(200ms));
  ASSERT_TRUE(second);
  EXPECT_EQ(second->left.stamp_ns, Duration(200ms).count());
  EXPECT_EQ(second->right.stamp_ns, Duration(203ms).count());
  EXPECT_FALSE(pairing.add_left(at(100ms))) << "its partner is older than a pair already found";
}

TEST(StereoPairing, LeavesImagesThatAreTooFarApartAlone) {
  StereoPairing pairing(20ms);
  EXPECT_FALSE(pairing.add_left(at(100ms)));
  EXPECT_FALSE(pairing.add_right(at(121ms)));
  EXPECT_TRUE(pairing.add_left(at(120ms)));
}

TEST(StereoPairing, UsesAnImageOnce) {
  StereoPairing pairing(20ms);
  EXPECT_FALSE(pairing.add_left(at(100ms)));
  EXPECT_TRUE(pairing.add_right(at(100ms)));
  EXPECT_FALSE(pairing.add_right(at(105ms)));
}

TEST(StereoPairing, OneSilentEyeFillsNoMemoryAndTheNewestArePaired) {
  StereoPairing pairing(20ms);
  for (int i = 0; i < 1000; ++i) EXPECT_FALSE(pairing.add_left(at(i * 100ms)));
  EXPECT_FALSE(pairing.add_right(at(0ms))) << "long forgotten";
  EXPECT_TRUE(pairing.add_right(at(99900ms)));
}

}  // namespace
}  // namespace striate::remote
