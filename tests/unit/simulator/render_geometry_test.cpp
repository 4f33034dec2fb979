#include <cmath>
#include <opencv2/imgproc.hpp>

#include "render_world.hpp"
#include "striate/base/user_error.hpp"

namespace striate::simulator::test {
namespace {

TEST(Renderer, KnowsTheDepthOfAWallAheadToTheMillimetre) {
  const World world = bright_corridor();
  Renderer renderer(world, build_floor_plan(world), clean_camera(), 1);
  const cv::Mat1f depth = renderer.true_depth(standing_at(4.0, 0.0), 160);
  ASSERT_EQ(depth.size(), cv::Size(160, 120));
  // Depth is along the axis: the whole end wall, 8 m ahead, has one value.
  EXPECT_NEAR(depth(60, 80), 8.0F, 1e-3F);
  EXPECT_NEAR(depth(60, 90), 8.0F, 1e-3F);
  // The left camera stands 0.06 m to the left of the middle, so 1.14 m from the left wall, whose
  // depth along the row is 1.14 m times focal length over column.
  const double focal = 80.0 / std::tan(radians(21.5));
  EXPECT_NEAR(depth(60, 0), 1.14 * focal / 79.5, 2e-3);
}

TEST(Renderer, LooksDownByTheTiltAndSideways) {
  const World world = bright_corridor();
  Renderer renderer(world, build_floor_plan(world), clean_camera(), 1);
  SceneState state = standing_at(4.0, 0.0);
  state.head.tilt_rad = radians(-30.0);
  // The axis meets the floor at 1.20 m / sin 30.
  EXPECT_NEAR(renderer.true_depth(state, 160)(60, 80), 2.4F, 0.03F);
  state.head = {radians(90.0), 0.0};
  // Panned to the left, the camera looks at the left wall; the left camera moves backwards.
  EXPECT_NEAR(renderer.true_depth(state, 160)(60, 80), 1.2F, 2e-3F);
  state.head = {radians(-90.0), 0.0};
  state.robot.y_m = 0.5;
  EXPECT_NEAR(renderer.true_depth(state, 160)(60, 80), 1.7F, 2e-3F);
}

TEST(Renderer, ShiftsATexturedWallByFocalLengthTimesBaselineOverDistance) {
  World world = bright_corridor();
  world.wall_material = "brick";
  Renderer renderer(world, build_floor_plan(world), clean_camera(320), 1);
  const StereoFrame frame = renderer.image(standing_at(10.0, 0.0));  // 2 m before the end wall
  EXPECT_NEAR(frame.focal_px, 160.0 / std::tan(radians(21.5)), 1e-3);
  EXPECT_DOUBLE_EQ(frame.centre_u_px, 159.5);
  EXPECT_DOUBLE_EQ(frame.centre_v_px, 119.5);
  EXPECT_DOUBLE_EQ(frame.baseline_m, 0.12);
  // Sub-pixel shift of the end wall's middle by phase correlation; the left image's content
  // stands further right.
  const cv::Rect middle(100, 60, 120, 100);
  cv::Mat left;
  cv::Mat right;
  cv::cvtColor(frame.left, left, cv::COLOR_BGR2GRAY);
  cv::cvtColor(frame.right, right, cv::COLOR_BGR2GRAY);
  const double expected = frame.focal_px * 0.12 / 2.0;
  const cv::Rect moved = middle - cv::Point(static_cast<int>(std::lround(expected)), 0);
  cv::Mat a;
  cv::Mat b;
  left(middle).convertTo(a, CV_64F);
  right(moved).convertTo(b, CV_64F);
  cv::Mat window;
  cv::createHanningWindow(window, a.size(), CV_64F);
  const cv::Point2d rest = cv::phaseCorrelate(a, b, window);
  const double measured = std::lround(expected) - rest.x;
  EXPECT_NEAR(measured, expected, 0.15);
  EXPECT_NEAR(rest.y, 0.0, 0.1);
}

TEST(Renderer, PutsThingsWhereTheWorldSaysInThePlan) {
  World world = bright_corridor();
  WorldObstacle box;
  box.kind = ObstacleKind::styrofoam_box;
  box.at = {7.0, 0.0};
  box.size_x_m = 0.4;
  box.size_z_m = 1.5;
  world.obstacles = {box};
  Renderer renderer(world, build_floor_plan(world), clean_camera(), 1);
  EXPECT_NEAR(renderer.true_depth(standing_at(4.0, 0.0), 160)(60, 80), 2.8F, 1e-3F);
}

TEST(Renderer, FollowsABend) {
  World world = bright_corridor();
  world.turns = {{6.0, radians(90.0)}};
  const FloorPlan plan = build_floor_plan(world);
  Renderer renderer(world, plan, clean_camera(), 1);
  SceneState state;
  state.robot = plan.at(8.0, 0.0);  // in the second leg, 4 m before the end
  EXPECT_NEAR(renderer.true_depth(state, 160)(60, 80), 4.0F, 1e-3F);
}

TEST(Renderer, ShowsAPersonWhereHeStands) {
  const World world = bright_corridor();
  Renderer renderer(world, build_floor_plan(world), clean_camera(), 1);
  SceneState state = standing_at(4.0, 0.0);
  const cv::Mat3b empty = renderer.image(state).left.clone();
  PersonState person;
  person.pose = {7.0, 0.06, 0.0};  // straight ahead of the left camera
  state.people = {person};
  const cv::Mat1f depth = renderer.true_depth(state, 160);
  EXPECT_NEAR(depth(60, 80), 3.0F, 0.25F);
  // Head to foot: 1.78 m of person, eyes at 1.20 m.
  const double focal = 80.0 / std::tan(radians(21.5));
  const auto row = [&](double height_m) {
    return static_cast<int>(59.5 + focal * (1.2 - height_m) / 3.0);
  };
  EXPECT_LT(depth(row(1.7), 80), 3.3F);
  EXPECT_GT(depth(row(1.9), 80), 3.6F);
  const cv::Mat3b with = renderer.image(state).left;
  EXPECT_GT(cv::norm(empty(cv::Rect(72, 50, 16, 30)), with(cv::Rect(72, 50, 16, 30)), cv::NORM_L1) /
                (16 * 30 * 3),
            10.0);
  // Moved aside, he is gone from the middle.
  state.people[0].pose.y_m = 0.9;
  EXPECT_GT(renderer.true_depth(state, 160)(60, 80), 7.0F);
}

TEST(Renderer, NamesAMaterialThatIsNeitherShippedNorAFile) {
  World world = bright_corridor();
  world.wall_material = "plastre";
  try {
    Renderer renderer(world, build_floor_plan(world), clean_camera(), 1);
    FAIL() << "an unknown material was taken";
  } catch (const UserError& error) {
    EXPECT_NE(std::string(error.what()).find("plastre"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("plaster"), std::string::npos) << error.what();
  }
  world = bright_corridor();
  Poster poster;
  poster.at_m = 3.0;
  poster.image = "no/such/picture.png";
  world.posters = {poster};
  EXPECT_THROW(Renderer(world, build_floor_plan(world), clean_camera(), 1), UserError);
}

}  // namespace
}  // namespace striate::simulator::test
