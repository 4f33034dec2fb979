#include "striate/platform/ros/bag_robot.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "striate/base/user_error.hpp"
#include "tests/reference/temporary_folder.hpp"
#include "tests/unit/ros/written_bag.hpp"

/// None of these tests has a ROS master.
namespace striate::ros {
namespace {

using reference::TemporaryFolder;

std::string diagnostic(const std::string& file) {
  try {
    BagRobot robot(file, {});
  } catch (const UserError& error) {
    return error.what();
  }
  return "";
}

TEST(BagRobot, HandsOutEachPairWithCameraAndOdometry) {
  const TemporaryFolder folder;
  write_bag(folder / "a.bag", {});
  BagRobot robot(folder / "a.bag", {});
  Senses senses;
  for (int i = 0; i < 5; ++i) {
    ASSERT_TRUE(robot.sense(senses)) << i;
    EXPECT_EQ(senses.stereo.left(60, 80)[0], 10 * i);
    EXPECT_EQ(senses.stereo.right(60, 80)[0], 200);
    EXPECT_NEAR(senses.stereo.focal_px, 203.0, 1e-9);
    EXPECT_NEAR(senses.stereo.baseline_m, 0.12, 1e-9);
    EXPECT_EQ(senses.now, robot.clock().now());
    EXPECT_LT(to_seconds(senses.now - senses.stereo.stamp), 0.05);
    // The first place is the origin, and ahead is where it looked then.
    EXPECT_NEAR(senses.odometry.pose.x_m, 0.03 * i, 0.016);
    EXPECT_NEAR(senses.odometry.pose.y_m, 0.0, 1e-9);
    EXPECT_NEAR(senses.odometry.pose.heading_rad, 0.0, 1e-9);
  }
  EXPECT_FALSE(robot.sense(senses));
  EXPECT_FALSE(robot.sense(senses));
}

TEST(BagRobot, FindsTopicsByTheirKindAndReadsCompressedImages) {
  const TemporaryFolder folder;
  WrittenBag other;
  other.compressed = true;
  other.root = "/bumblebee";
  other.image = "/image_raw";
  write_bag(folder / "b.bag", other);
  BagRobot robot(folder / "b.bag", {});
  Senses senses;
  int pairs = 0;
  while (robot.sense(senses)) ++pairs;
  EXPECT_EQ(pairs, 5);
  EXPECT_EQ(senses.stereo.left(60, 80)[0], 40);
}

TEST(BagRobot, OfTwoStereoCamerasOneIsChosenAndNoEyeOfTheOther) {
  const TemporaryFolder folder;
  WrittenBag front;
  front.root = "/stereo_a";
  WrittenBag rear;
  rear.root = "/stereo_b";
  rear.image = "/image_raw";
  rear.paint = [](int, StereoFrame& frame) {
    frame.left.setTo(cv::Scalar::all(77));
    frame.baseline_m = 0.3;
  };
  write_bag(folder / "both.bag", front);
  rear.append = true;
  write_bag(folder / "both.bag", rear);
  EXPECT_THAT(
      diagnostic(folder / "both.bag"),
      testing::AllOf(testing::HasSubstr("both.bag: the bag has several stereo cameras"),
                     testing::HasSubstr("/stereo_a/left/image_rect_color and "
                                        "/stereo_a/right/image_rect_color"),
                     testing::HasSubstr("/stereo_b/left/image_raw and /stereo_b/right/image_raw"),
                     testing::HasSubstr("--camera")));
  BagRobot robot(folder / "both.bag", {}, {}, "stereo_b");
  EXPECT_EQ(robot.settings().left_info, "/stereo_b/left/camera_info");
  Senses senses;
  ASSERT_TRUE(robot.sense(senses));
  EXPECT_EQ(senses.stereo.left(60, 80)[0], 77);
  EXPECT_NEAR(senses.stereo.baseline_m, 0.3, 1e-9);
  EXPECT_THROW(BagRobot(folder / "both.bag", {}, {}, "/stereo_c"), UserError);
}

TEST(BagRobot, TheSettingsGiveACameraWhereTheBagDoesNot) {
  const TemporaryFolder folder;
  WrittenBag bare;
  bare.with_info = false;
  write_bag(folder / "c.bag", bare);
  EXPECT_THAT(diagnostic(folder / "c.bag"), testing::HasSubstr("ros.focal"));
  RosSettings settings;
  settings.focal_px = 210.0;
  settings.baseline_m = 0.2;
  BagRobot robot(folder / "c.bag", settings);
  Senses senses;
  ASSERT_TRUE(robot.sense(senses));
  EXPECT_EQ(senses.stereo.focal_px, 210.0);
  EXPECT_EQ(senses.stereo.baseline_m, 0.2);
  EXPECT_EQ(senses.stereo.centre_u_px, 79.5);
}

TEST(BagRobot, SaysWhatIsWrongWithABag) {
  const TemporaryFolder folder;
  EXPECT_THAT(diagnostic(folder / "none.bag"), testing::HasSubstr("no ROS bag"));
  EXPECT_THAT(diagnostic(folder.write("text.bag", "hello")), testing::HasSubstr("no ROS bag"));
  {
    rosbag::Bag bag(folder / "wheels.bag", rosbag::bagmode::Write);
    bag.write("/odom", ::ros::Time(10, 0), nav_msgs::Odometry());
  }
  EXPECT_THAT(diagnostic(folder / "wheels.bag"),
              testing::AllOf(testing::HasSubstr("has no stereo images"),
                             testing::HasSubstr("/odom: nav_msgs/Odometry")));
  { const rosbag::Bag empty(folder / "empty.bag", rosbag::bagmode::Write); }
  EXPECT_THAT(diagnostic(folder / "empty.bag"), testing::HasSubstr("has no stereo images"));
  write_bag(folder / "cut.bag", {});
  std::filesystem::resize_file(folder / "cut.bag",
                               std::filesystem::file_size(folder / "cut.bag") / 2);
  EXPECT_THAT(diagnostic(folder / "cut.bag"), testing::HasSubstr("no ROS bag"));
}

}  // namespace
}  // namespace striate::ros
