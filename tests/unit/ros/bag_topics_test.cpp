#include "striate/platform/ros/bag_topics.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "striate/base/user_error.hpp"

namespace striate::ros {
namespace {

BagTopics topics_with(const std::vector<std::string>& images,
                      const std::vector<std::string>& infos = {}) {
  BagTopics topics;
  for (const std::string& name : images) topics[name] = "sensor_msgs/Image";
  for (const std::string& name : infos) topics[name] = "sensor_msgs/CameraInfo";
  return topics;
}

std::string refusal(const BagTopics& topics, const std::string& camera = {}) {
  try {
    (void)find_topics(topics, {}, camera);
  } catch (const UserError& error) {
    return error.what();
  }
  return "";
}

TEST(BagTopics, EyesAreFoundByNamesThatDifferInTheEyeAlone) {
  for (const auto& [left, right] :
       {std::pair<std::string, std::string>{"/a/left/image_raw", "/a/right/image_raw"},
        {"/cam/left_image", "/cam/right_image"},
        {"/leftward/stereo/left/i", "/leftward/stereo/right/i"},
        {"/left/cam_left/i", "/right/cam_right/i"},
        {"/ns/Left/image", "/ns/Right/image"},
        {"/ns/LEFT/image", "/ns/RIGHT/image"}}) {
    const RosSettings found = find_topics(topics_with({left, right}), {});
    EXPECT_EQ(found.left_image, left);
    EXPECT_EQ(found.right_image, right);
  }
}

// "/a/left" goes before "/b/left", and "/b/right_rect" before "/a/right_raw": no pair at all.
TEST(BagTopics, EyesOfTwoCamerasAreNoPair) {
  const RosSettings found =
      find_topics(topics_with({"/a/left/image_raw", "/b/right/image_rect_color"}), {});
  EXPECT_EQ(found.left_image, "/" + RosSettings{}.left_image);
  const BagTopics both = topics_with(
      {"/a/left/image_raw", "/a/right/image_raw", "/b/left/image_rect", "/b/right/image_rect"});
  EXPECT_THAT(refusal(both),
              testing::AllOf(testing::HasSubstr("/a/left/image_raw and /a/right/image_raw"),
                             testing::HasSubstr("/b/left/image_rect and /b/right/image_rect")));
  EXPECT_EQ(find_topics(both, {}, "a").right_image, "/a/right/image_raw");
  EXPECT_EQ(find_topics(both, {}, "/b/").left_image, "/b/left/image_rect");
  EXPECT_THAT(refusal(both, "c"), testing::HasSubstr("begin with /c; it has:"));
}

TEST(BagTopics, OneCameraIsOneHoweverManyKindsOfImagesItSends) {
  const BagTopics topics =
      topics_with({"/s/left/image_raw", "/s/right/image_raw", "/s/left/image_rect",
                   "/s/right/image_rect", "/s/left/image_rect_color"});
  EXPECT_EQ(find_topics(topics, {}).left_image, "/s/left/image_rect");
  EXPECT_EQ(find_topics(topics, {}).right_image, "/s/right/image_rect");
}

TEST(BagTopics, AnEyeThatTheSettingsNameGetsItsOwnPartner) {
  const BagTopics both = topics_with({"/a/left/i", "/a/right/i", "/b/left/i", "/b/right/i"});
  RosSettings wanted;
  wanted.left_image = "/b/left/i";
  EXPECT_EQ(find_topics(both, wanted).right_image, "/b/right/i");
  wanted.right_image = "/a/left/i";
  EXPECT_EQ(find_topics(both, wanted).right_image, "/a/left/i") << "as it is told";
}

TEST(BagTopics, CameraInfoIsThatOfTheSameEye) {
  const BagTopics topics = topics_with({"/b/left/image_raw", "/b/right/image_raw"},
                                       {"/a/left/camera_info", "/a/right/camera_info",
                                        "/b/left/camera_info", "/b/right/camera_info"});
  const RosSettings found = find_topics(topics, {});
  EXPECT_EQ(found.left_info, "/b/left/camera_info");
  EXPECT_EQ(found.right_info, "/b/right/camera_info");
  const BagTopics flat = topics_with({"/b/left_image", "/b/right_image"},
                                     {"/b/left_info", "/b/right_info", "/a/left_info"});
  EXPECT_EQ(find_topics(flat, {}).left_info, "/b/left_info");
  EXPECT_EQ(find_topics(flat, {}).right_info, "/b/right_info");
  RosSettings numbered;
  numbered.left_image = "/cam0/image_raw";
  numbered.right_image = "/cam1/image_raw";
  const BagTopics euroc = topics_with({"/cam0/image_raw", "/cam1/image_raw"},
                                      {"/cam0/camera_info", "/cam1/camera_info"});
  EXPECT_EQ(find_topics(euroc, numbered).left_info, "/cam0/camera_info");
  EXPECT_EQ(find_topics(euroc, numbered).right_info, "/cam1/camera_info");
}

}  // namespace
}  // namespace striate::ros
