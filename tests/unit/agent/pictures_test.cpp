#include <gtest/gtest.h>

#include <opencv2/core.hpp>

#include "striate/agent/pictures/disparity_colours.hpp"
#include "striate/agent/pictures/label_places.hpp"
#include "striate/agent/pictures/overview.hpp"
#include "striate/agent/pictures/plan_of_columns.hpp"
#include "striate/agent/pictures/scene_pictures.hpp"

namespace striate::agent::pictures {
namespace {

perception::DisparityMap step_map() {
  perception::DisparityMap map;
  map.disparity_px = cv::Mat1f(120, 160, 3.0F);
  map.disparity_px(cv::Rect(80, 0, 80, 120)).setTo(20.0F);
  map.disparity_px(cv::Rect(0, 0, 40, 120)).setTo(perception::kNoMatch);
  map.confidence = cv::Mat1f(120, 160, 0.9F);
  map.focal_px = 203.0;
  map.centre_u_px = 79.5;
  map.centre_v_px = 59.5;
  map.baseline_m = 0.12;
  return map;
}

perception::Percept percept_with_board() {
  perception::Percept percept;
  percept.valid = true;
  percept.disparity = step_map();
  percept.columns.resize(160);
  for (int u = 0; u < 160; ++u) {
    percept.columns[u].bearing_rad = std::atan((79.5 - u) / 203.0);
    if (u >= 80) {
      percept.columns[u].obstacle_m = 1.218 / std::cos(percept.columns[u].bearing_rad);
      percept.columns[u].obstacle_confidence = 0.9;
    }
  }
  percept.obstacles.push_back({-0.18, 1.22, 0.47, 1.0, 0.9, 80, 159});
  percept.saliency.salience = cv::Mat1f(120, 160, 0.1F);
  percept.saliency.salience(cv::Rect(20, 20, 24, 24)).setTo(1.0F);
  percept.saliency.regions.push_back({31.5, 31.5, 24, 24, 1.0, 0.26, perception::kNothing_m});
  return percept;
}

StereoFrame grey_frame() {
  StereoFrame frame;
  frame.left = cv::Mat3b(240, 320, cv::Vec3b(120, 120, 120));
  frame.right = frame.left.clone();
  frame.focal_px = 406.0;
  frame.baseline_m = 0.12;
  return frame;
}

TEST(LabelPlaces, LieOnNothingThatIsToBeSeenAndNotOnEachOther) {
  LabelPlaces places({400, 200});
  // A driven path across the picture, and a thing right above the anchor.
  places.taken()(cv::Rect(0, 98, 400, 5)).setTo(255);
  places.taken()(cv::Rect(180, 60, 40, 30)).setTo(255);
  const cv::Mat1b before = places.taken().clone();
  std::vector<cv::Rect> taken;
  for (const cv::Point anchor : {cv::Point(200, 100), {200, 100}, {210, 95}, {399, 0}, {0, 199}}) {
    const cv::Rect place = places.take(anchor, {70, 14});
    EXPECT_EQ(place & cv::Rect(0, 0, 400, 200), place);
    EXPECT_EQ(cv::countNonZero(before(place)), 0) << place;
    for (const cv::Rect& other : taken) EXPECT_TRUE((place & other).empty()) << place << other;
    taken.push_back(place);
  }
}

TEST(LabelPlaces, CoverLeastWhereThereIsNoRoomAndAreNeverLargerThanThePicture) {
  LabelPlaces places({50, 40});
  places.taken().setTo(255);
  EXPECT_EQ(places.take({-10, 500}, {20, 10}).size(), cv::Size(20, 10));
  EXPECT_EQ(places.take({25, 20}, {300, 90}), cv::Rect(0, 0, 50, 40));
}

TEST(DisparityColours, NearIsRedFarIsBlueAndUnknownIsDark) {
  const perception::DisparityMap map = step_map();
  const cv::Mat3b image = colour_disparity(map, scale_for(map), {160, 120});
  const cv::Vec3b near = image(60, 120);
  const cv::Vec3b far = image(60, 60);
  const cv::Vec3b unknown = image(60, 20);
  EXPECT_GT(near[2], near[0] + 50);
  EXPECT_GT(far[0], far[2] + 50);
  EXPECT_LT(unknown[0] + unknown[1] + unknown[2], 200);
}

TEST(DisparityColours, AKnownCameraHasTheSameColoursInEveryImage) {
  perception::DisparityMap near = step_map();
  near.disparity_px.setTo(30.0F);
  EXPECT_EQ(scale_for(near).most_px, scale_for(step_map()).most_px);
  near.baseline_m = 0.0;
  EXPECT_EQ(scale_for(near).focal_baseline, 0.0);
  EXPECT_EQ(scale_for(near).most_px, 30.0);
}

TEST(ScenePictures, TintsWhatStandsRedAndLeavesTheRestGrey) {
  const cv::Mat3b image = draw_obstacles(grey_frame(), percept_with_board(), {320, 240});
  const cv::Vec3b standing = image(60, 240);
  EXPECT_GT(standing[2], standing[0] + 15);
  const cv::Vec3b rest = image(60, 100);
  EXPECT_EQ(rest[0], rest[2]);
}

TEST(ScenePictures, TintsFreeFloorGreen) {
  StereoFrame frame = grey_frame();
  frame.head.tilt_rad = -0.3;
  perception::Percept percept = percept_with_board();
  percept.obstacles.clear();
  for (perception::Column& c : percept.columns) c = {c.bearing_rad, 1.0, 3.0, 0.9};
  const cv::Mat3b image = draw_obstacles(frame, percept, {320, 240});
  const cv::Vec3b floor = image(230, 160);
  EXPECT_GT(floor[1], floor[2] + 10);
  const cv::Vec3b above = image(20, 160);
  EXPECT_EQ(above[1], above[2]);
}

TEST(ScenePictures, SalienceGlowsWhereItIs) {
  const cv::Mat3b image = draw_saliency(grey_frame(), percept_with_board(), {320, 240});
  EXPECT_GT(image(78, 78)[1], image(150, 200)[1] + 60);
}

TEST(PlanOfColumns, DrawsObstaclesOnTheSideWhereTheyAre) {
  const cv::Mat3b plan = draw_plan_of_columns(percept_with_board(), {300, 300}, {});
  int left = 0;
  int right = 0;
  for (int v = 0; v < 300; ++v) {
    for (int u = 0; u < 300; ++u) {
      const cv::Vec3b p = plan(v, u);
      if (p[2] > 150 && p[0] < 100) ++(u < 150 ? left : right);
    }
  }
  EXPECT_GT(right, 50);
  EXPECT_LT(left, right / 5);
}

TEST(Overview, IsDrawnForAnyPercept) {
  const cv::Mat3b whole = draw_overview(grey_frame(), percept_with_board());
  EXPECT_GT(whole.cols, 3 * 480);
  StereoFrame one_eye = grey_frame();
  one_eye.right.release();
  perception::Percept only_salience;
  only_salience.valid = true;
  EXPECT_EQ(draw_overview(one_eye, only_salience).size(), whole.size());
  EXPECT_FALSE(draw_overview({}, {}).empty());
}

}  // namespace
}  // namespace striate::agent::pictures
