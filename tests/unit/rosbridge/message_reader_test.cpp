#include "striate/platform/rosbridge/message_reader.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/imgcodecs.hpp>

#include "striate/platform/rosbridge/json_fields.hpp"
#include "tests/unit/rosbridge/robot_messages.hpp"

namespace striate::rosbridge {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::StartsWith;

constexpr std::int64_t kStamp_ns = 1'700'000'000'123'456'789;

BridgeSettings raw_images() {
  BridgeSettings settings;
  settings.topics.left_image = "/left/image";
  settings.topics.right_image = "/right/image";
  settings.topics.left_info = "/left/info";
  settings.topics.right_info = "/right/info";
  settings.topics.scan = "/scan";
  return settings;
}

std::string trouble_of(const Heard& heard) {
  const auto* trouble = std::get_if<HeardTrouble>(&heard);
  return trouble == nullptr ? "" : trouble->what;
}

std::string trouble_of(const std::string& text) {
  return trouble_of(MessageReader(raw_images()).read(text));
}

class MessagesOf : public testing::TestWithParam<bool> {};

TEST_P(MessagesOf, BothVersionsOfRosAreUnderstood) {
  const bool two = GetParam();
  MessageReader reader(raw_images());
  const auto odometry = std::get<HeardOdometry>(
      reader.read(published("/odom", odometry_message(two, kStamp_ns, 1.5, 0.3))));
  EXPECT_EQ(odometry.stamp_ns, kStamp_ns);
  EXPECT_EQ(odometry.odometry.pose.x_m, 1.5);
  EXPECT_EQ(odometry.odometry.pose.y_m, -2.0);
  EXPECT_NEAR(odometry.odometry.pose.heading_rad, kPi / 2.0, 1e-12)
      << "a quaternion of any length turns as its direction says";
  EXPECT_EQ(odometry.odometry.forward_m_s, 0.3);
  EXPECT_EQ(odometry.odometry.turn_rad_s, -0.25);

  const auto camera =
      std::get<HeardCamera>(reader.read(published("/right/info", camera_message(two, 0.12))));
  EXPECT_EQ(camera.eye, remote::Eye::right);
  EXPECT_EQ(camera.info.width_px, 64);
  EXPECT_NEAR(camera.info.projection[3], -7.2, 1e-12);

  const auto image =
      std::get<HeardImage>(reader.read(published("/left/image", image_message(two, kStamp_ns))));
  EXPECT_EQ(image.eye, remote::Eye::left);
  EXPECT_EQ(image.image.stamp_ns, kStamp_ns);
  EXPECT_EQ(image.image.image.size(), cv::Size(64, 48));
  EXPECT_EQ(image.image.image(47, 63), cv::Vec3b(77, 77, 77));

  const auto scan =
      std::get<HeardScan>(reader.read(published("/scan", scan_message(two, kStamp_ns))));
  ASSERT_EQ(scan.scan.readings.size(), 2u) << "null says nothing";
  EXPECT_NEAR(scan.scan.readings[0].bearing_rad, 0.0, 1e-12);
  EXPECT_EQ(scan.scan.readings[0].distance_m, 2.0);
  EXPECT_TRUE(std::isinf(scan.scan.readings[1].distance_m));
}

INSTANTIATE_TEST_SUITE_P(RosOneAndTwo, MessagesOf, testing::Bool());

TEST(MessageReader, CompressedImagesAndListsOfBytesAreImages) {
  BridgeSettings settings = raw_images();
  settings.topics.left_image = "/left/image/compressed";
  MessageReader reader(settings);
  std::vector<std::uint8_t> png;
  cv::imencode(".png", cv::Mat3b(20, 30, cv::Vec3b(9, 8, 7)), png);
  const json in_letters = {{"format", "png"}, {"data", to_base64(png)}};
  const json in_numbers = {{"format", "png"}, {"data", png}};
  for (const json& message : {in_letters, in_numbers}) {
    const auto heard =
        std::get<HeardImage>(reader.read(published("/left/image/compressed", message)));
    EXPECT_EQ(heard.image.image(19, 29), cv::Vec3b(9, 8, 7));
    EXPECT_EQ(heard.image.stamp_ns, 0) << "no header, no stamp";
  }
}

TEST(MessageReader, WhatTheServerSaysOfOurRequestsIsATroubleOfTheKindThatItTells) {
  EXPECT_EQ(trouble_of(R"({"op":"status","level":"error","msg":"no such\ntopic"})"),
            "the server says: no such\\u000Atopic");
  EXPECT_EQ(trouble_of(R"({"op":"status","level":"warning"})"), "the server says: nothing");
  EXPECT_EQ(trouble_of(R"({"op":"status","level":"info","msg":"hello"})"), "");
  EXPECT_EQ(trouble_of(R"({"op":"service_response","service":"/x","result":true})"), "");
  EXPECT_EQ(trouble_of(R"({"op":"publish","topic":"/others","msg":{"data":1}})"), "");
}

TEST(MessageReader, FragmentsAndPicturesOfMessagesAreRefusedInASentence) {
  EXPECT_EQ(trouble_of(R"({"op":"fragment","id":"1","data":"{","num":0,"total":2})"),
            "the server sends messages as 'fragment', though none was asked for");
  EXPECT_EQ(trouble_of(R"({"op":"png","data":"iVBOR"})"),
            "the server sends messages as 'png', though none was asked for");
}

TEST(MessageReader, HostileJsonIsATroubleAndNothingElse) {
  EXPECT_EQ(trouble_of(""), "a message is no JSON object");
  EXPECT_EQ(trouble_of("[1, 2]"), "a message is no JSON object");
  EXPECT_EQ(trouble_of(std::string("{\"op\":\"\xff\"}")), "a message is no JSON object");
  EXPECT_EQ(trouble_of("{}"), "'op' is missing");
  EXPECT_EQ(trouble_of(R"({"op":7})"), "'op' is no text");
  EXPECT_EQ(trouble_of(R"({"op":"publish","topic":"/odom","msg":[]})"),
            "/odom: 'msg' is no object");
  const std::string deep(100'000, '[');
  EXPECT_EQ(trouble_of(R"({"op":"publish","topic":"/odom","msg":)" + deep),
            "a message is nested too deeply");
}

TEST(MessageReader, OdometryWithoutANumberIsRefusedByItsField) {
  const json good = odometry_message(true, kStamp_ns, 1.0, 0.1);
  const auto with = [&good](const char* pointer, const json& value) {
    json bad = good;
    bad[json::json_pointer(pointer)] = value;
    return trouble_of(published("/odom", bad));
  };
  EXPECT_EQ(with("/pose/pose/position/x", nullptr), "/odom: 'position.x' is no number");
  EXPECT_EQ(with("/twist/twist/angular/z", "fast"), "/odom: 'twist.twist.angular.z' is no number");
  EXPECT_EQ(with("/pose/pose/orientation", {{"x", 0}, {"y", 0}, {"z", 0}, {"w", 0}}),
            "/odom: 'orientation' points nowhere");
  EXPECT_THAT(with("/header/stamp/sec", -1), StartsWith("/odom: 'sec' is no whole number"));
  EXPECT_THAT(with("/header/stamp/nanosec", 1'000'000'000), HasSubstr("'nanosec'"));
  EXPECT_EQ(with("/twist", json::object()), "/odom: 'twist.twist.linear.x' is missing");
  // As Python writes it, which is no JSON.
  EXPECT_EQ(trouble_of(R"({"op":"publish","topic":"/odom","msg":{"x":NaN}})"),
            "a message is no JSON object");
}

TEST(MessageReader, ImagesAndCamerasThatCannotBeAreRefused) {
  const auto image = [](const char* key, const json& value) {
    json bad = image_message(true, kStamp_ns);
    bad[key] = value;
    return trouble_of(published("/left/image", bad));
  };
  EXPECT_EQ(image("data", "*wrong*"), "/left/image: 'data' is no base64");
  EXPECT_EQ(image("data", {1, 2, 256}), "/left/image: 'data' has numbers that are no bytes");
  EXPECT_EQ(image("data", 3), "/left/image: 'data' is neither base64 nor a list");
  EXPECT_THAT(image("data", "AAAA"), HasSubstr("does not agree with its data"));
  EXPECT_THAT(image("width", 4'294'967'295), HasSubstr("does not agree with its data"));
  EXPECT_THAT(image("height", 4'294'967'296), HasSubstr("'height' is no whole number"));
  EXPECT_THAT(image("step", 0), HasSubstr("does not agree with its data"));
  EXPECT_THAT(image("encoding", "yuv422"), HasSubstr("'yuv422' are not understood"));
  json camera = camera_message(true, 0.1);
  camera["p"] = {1, 2, 3};
  EXPECT_EQ(trouble_of(published("/left/info", camera)), "/left/info: 'p' has not 12 numbers");
  camera["p"] = std::vector<int>(13, 1);
  EXPECT_THAT(trouble_of(published("/left/info", camera)), HasSubstr("12 can be used"));
  json scan = scan_message(true, kStamp_ns);
  scan["ranges"] = std::vector<int>(100'001, 1);
  EXPECT_THAT(trouble_of(published("/scan", scan)), HasSubstr("100000 can be used"));
}

TEST(MessageReader, ATroubleChangesNothingThatIsFelt) {
  remote::Inbox inbox{remote::RemoteSettings{}};
  MessageReader reader(raw_images());
  take(reader.read(published("/odom", odometry_message(true, 0, 1.0, 0.2))), TimePoint(), inbox);
  ASSERT_TRUE(inbox.odometry_came());
  take(reader.read("nonsense"), TimePoint(std::chrono::seconds(1)), inbox);
  EXPECT_EQ(inbox.senses().odometry.forward_m_s, 0.2);
  EXPECT_EQ(inbox.odometry_came(), TimePoint());
  EXPECT_EQ(inbox.trouble(), "a message is no JSON object");
  json far = odometry_message(true, 0, 1e300, 0.2);
  take(reader.read(published("/odom", far)), TimePoint(std::chrono::seconds(1)), inbox);
  EXPECT_EQ(inbox.odometry_came(), TimePoint());
  EXPECT_THAT(inbox.trouble(), HasSubstr("the odometry's x"));
}

}  // namespace
}  // namespace striate::rosbridge
