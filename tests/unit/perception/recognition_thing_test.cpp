#include <gtest/gtest.h>

#include <cmath>

#include "striate/perception/recognition/thing_region.hpp"

namespace striate::perception {
namespace {

/// A thing 12 px of disparity away before a wall at 8 px; a salient region that is a little larger.
Percept thing_before_a_wall() {
  Percept percept;
  percept.disparity.focal_px = 203.0;
  percept.disparity.centre_u_px = 79.5;
  percept.disparity.centre_v_px = 59.5;
  percept.disparity.baseline_m = 0.12;
  percept.disparity.disparity_px = cv::Mat1f(120, 160, 8.0F);
  percept.disparity.disparity_px(cv::Rect(70, 50, 24, 30)).setTo(12.0F);
  percept.disparity.disparity_px(cv::Rect(80, 60, 2, 2)).setTo(kNoMatch);
  percept.saliency.regions.push_back({81.0, 64.0, 28.0, 34.0, 1.0, 0.0, 2.0});
  return percept;
}

TEST(ThingRegion, IsWhatIsSalientAndEquallyFar) {
  const Percept percept = thing_before_a_wall();
  const ViewGeometry geometry(percept.disparity, {}, {});
  const auto thing = find_thing(percept, geometry, 0.0);
  ASSERT_TRUE(thing.has_value());
  EXPECT_EQ(thing->box, cv::Rect(70, 50, 24, 30));
  EXPECT_NE(thing->mask(61, 81), 0) << "a gap in the disparity is no gap in the thing";
  EXPECT_EQ(thing->mask(64, 68), 0) << "the wall";
  const SpacePoint middle = geometry.point(81.5, 64.5, 12.0);
  EXPECT_NEAR(thing->distance_m, std::hypot(middle.x_m, middle.y_m), 1e-6);
  EXPECT_EQ(full_size_box(*thing, {640, 480}), cv::Rect(280, 200, 96, 120));
}

TEST(ThingRegion, IsNotThereWhereTheGazeOrTheDistanceSaysOtherwise) {
  Percept percept = thing_before_a_wall();
  const ViewGeometry geometry(percept.disparity, {}, {});
  EXPECT_FALSE(find_thing(percept, geometry, 0.3)) << "looks past it";
  percept.saliency.regions[0].distance_m = kNothing_m;
  EXPECT_FALSE(find_thing(percept, geometry, 0.0));
  percept.saliency.regions.clear();
  EXPECT_FALSE(find_thing(percept, geometry, 0.0));
}

}  // namespace
}  // namespace striate::perception
