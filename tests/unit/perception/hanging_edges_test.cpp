#include "striate/perception/hanging_edges/hanging_edges.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "striate/perception/perception.hpp"
#include "tests/unit/perception/low_things_pictures.hpp"

/// Edges of tables, bars and shelves, which run along the rows of both eyes.
namespace striate::perception {
namespace {

using synthetic::Picture;
using synthetic::Room;

TEST(LevelEdges, OfAWhiteBarAreItsTwoAndEndWhereItEnds) {
  cv::Mat1b grey(120, 200, uchar{60});
  cv::rectangle(grey, {40, 50, 101, 12}, cv::Scalar(200), cv::FILLED);
  const std::vector<LevelEdge> edges = find_level_edges(grey, {0, 120}, 12);
  ASSERT_EQ(edges.size(), 2U);
  for (const LevelEdge& edge : edges) {
    EXPECT_NEAR(edge.from_u_px, 40, 2);
    EXPECT_NEAR(edge.to_u_px, 140, 2);
    EXPECT_NEAR(edge.middle_row_px(), edge.brightens ? 49.5 : 61.5, 0.3);
    EXPECT_FALSE(edge.cut_left || edge.cut_right);
  }
}

TEST(LevelEdges, AreNotSteepAndKnowWhereTheImageCutsThem) {
  cv::Mat1b grey(120, 200, uchar{60});
  cv::rectangle(grey, {0, 50, 120, 70}, cv::Scalar(200), cv::FILLED);
  const std::vector<LevelEdge> edges = find_level_edges(grey, {0, 120}, 12);
  ASSERT_EQ(edges.size(), 1U);
  EXPECT_TRUE(edges[0].cut_left);
  EXPECT_FALSE(edges[0].cut_right);
}

/// A blank board on two posts, 1.2 m wide, seen from `away_m`.
Room bar(double away_m, double height_m) {
  return {{{away_m, away_m + 0.6, -0.6, 0.6, height_m - 0.12, height_m},
           {away_m + 0.03, away_m + 0.08, -0.57, -0.52, 0.0, height_m - 0.12},
           {away_m + 0.03, away_m + 0.08, 0.52, 0.57, 0.0, height_m - 0.12},
           {7.0, 7.2, -3.0, 3.0, 0.0, 2.7}},
          true,
          1.4,
          1.4};
}

/// Of the columns that the board fills within the middle metre, the share that sees it.
double share_that_sees_board(double away_m, double height_m, bool on) {
  PerceptionSettings settings;
  settings.hanging_edges.on = on;
  Perception eyes(settings, {});
  const HeadPose head{0.0, RobotDescription{}.resting_tilt_rad};
  Picture picture;
  picture.contrast = 50.0;
  picture.blank_above_m = 0.1;
  Room room = bar(away_m, height_m);
  StereoFrame frame = synthetic::photograph(room, head, picture);
  const Percept percept = eyes.see(frame);
  int seen = 0, columns = 0;
  for (const Column& column : percept.columns) {
    if (std::abs(std::tan(column.bearing_rad) * away_m) > 0.45) continue;
    ++columns;
    const double x_m = column.obstacle_m * std::cos(column.bearing_rad);
    seen += std::abs(x_m - away_m) < 0.25 && column.free_to_m < away_m + 0.1;
  }
  return columns > 0 ? static_cast<double>(seen) / columns : 0.0;
}

TEST(HangingEdges, ABlankBoardIsSeenByItsEnds) {
  for (const double height_m : {1.1, 0.75, 0.5}) {
    EXPECT_GT(share_that_sees_board(2.2, height_m, true), 0.8) << height_m;
  }
}

/// Columns that an edge 2 m away fills, where stereo sees what the map says.
int columns_with_edge(const DisparityMap& map) {
  const HeadPose head{0.0, 0.0};
  const ViewGeometry geometry(map, head, {});
  HangingEdge hanging;
  hanging.edge = {20, 99, std::vector<float>(80, 40.0F)};
  hanging.disparity_px = map.focal_px * map.baseline_m / 2.0;
  hanging.at_u_px = 20;
  hanging.both_ends = true;
  hanging.height_m = 0.8;
  hanging.distance_m = 2.0;
  ObstacleView view;
  view.columns.resize(static_cast<std::size_t>(map.disparity_px.cols));
  add_hanging_edges({hanging}, map, geometry, 1, view);
  return static_cast<int>(std::ranges::count_if(
      view.columns, [](const Column& column) { return column.hangs_from_m > 0.0; }));
}

TEST(HangingEdges, OneThatStereoSeesThroughOnBothSidesIsADrawing) {
  DisparityMap map;
  map.focal_px = 203.0;
  map.centre_u_px = 79.5;
  map.centre_v_px = 59.5;
  map.baseline_m = 0.12;
  map.disparity_px = cv::Mat1f(120, 160, kNoMatch);
  map.confidence = cv::Mat1f(120, 160, 0.0F);
  EXPECT_EQ(columns_with_edge(map), 80) << "nothing was matched there";
  map.disparity_px.setTo(static_cast<float>(203.0 * 0.12 / 4.0));
  map.confidence.setTo(0.5F);
  EXPECT_EQ(columns_with_edge(map), 80) << "what is filled in says nothing";
  map.confidence.setTo(0.9F);
  EXPECT_EQ(columns_with_edge(map), 0) << "a wall 4 m away, above and below";
  map.disparity_px.rowRange(0, 40).setTo(kNoMatch);
  EXPECT_EQ(columns_with_edge(map), 80) << "a board may hide what is above it";
}

TEST(HangingEdges, AnEmptyRoomHasNone) {
  const HeadPose head{0.0, RobotDescription{}.resting_tilt_rad};
  Perception eyes({}, {});
  const Percept percept = eyes.see(synthetic::photograph({{}, true, 3.0, 3.0}, head));
  for (const Column& column : percept.columns) EXPECT_EQ(column.hangs_from_m, 0.0);
}

}  // namespace
}  // namespace striate::perception
