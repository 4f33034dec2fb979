#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "striate/base/limits.hpp"
#include "striate/viewer/cdr/cdr_writer.hpp"
#include "striate/viewer/foxglove/conversation.hpp"
#include "striate/viewer/messages/common_messages.hpp"
#include "tests/unit/viewer/hand_clock.hpp"

/// The Foxglove protocol without sockets: what is said, and what drives.
namespace striate::viewer::foxglove {
namespace {

using nlohmann::json;
using testing::HasSubstr;

TEST(FoxgloveProtocol, TheFirstOfOurSubprotocolsIsChosen) {
  EXPECT_EQ(choose_subprotocol("x, foxglove.websocket.v1 ,foxglove.sdk.v1"),
            "foxglove.websocket.v1");
  EXPECT_EQ(choose_subprotocol("foxglove.sdk.v1"), "foxglove.sdk.v1");
  EXPECT_FALSE(choose_subprotocol("foxglove.sdk.v2,"));
  EXPECT_FALSE(choose_subprotocol(""));
}

TEST(FoxgloveProtocol, AnyBytesAreReadOrRefused) {
  const Bytes call{2, 1, 0, 0, 0, 7, 0, 0, 0, 3, 0, 0, 0, 'c', 'd', 'r'};
  for (std::size_t size = 0; size < call.size(); ++size) {
    EXPECT_THROW(read_binary_request(ByteView(call).first(size)), BadBytes) << size;
  }
  EXPECT_EQ(std::get<ServiceCall>(read_binary_request(call)).call, 7U);
  for (const char* text :
       {"", "[]", "{", "{}", R"({"op":1})", R"({"op":"subscribe"})",
        R"({"op":"subscribe","subscriptions":[{"id":-1,"channelId":0}]})",
        R"({"op":"subscribe","subscriptions":[1]})", R"({"op":"unsubscribe","subscriptionIds":1})",
        R"({"op":"subscribe","subscriptions":[{"id":4294967296,"channelId":0}]})",
        R"({"op":"subscribe","subscriptions":[{"id":1.5,"channelId":0}]})",
        R"({"op":"advertise","channels":[{"id":1}]})", "\xff\xfe"}) {
    EXPECT_THROW(read_text_request(text), BadBytes) << text;
  }
  EXPECT_THROW(read_text_request(std::string(60000, '[')), BadBytes);
  EXPECT_TRUE(std::holds_alternative<NotOffered>(read_text_request(R"({"op":"fetchAsset"})")));
}

class FoxgloveTalk : public testing::Test {
 protected:
  FoxgloveTalk() {
    host_.facts.name = "striate";
    host_.facts.drives = true;
    host_.facts.parameters = {{"safety.stop", "0.5 m"}, {"x.count", "3"}};
    host_.pilot = &pilot_;
    host_.stop = [this] { stopped_ = true; };
  }
  /// All that was answered in JSON since the last time.
  std::vector<json> answers() {
    std::vector<json> list;
    while (!talk_.queue().empty()) {
      const Frame frame = talk_.queue().pop();
      if (frame.text) list.push_back(json::parse(frame.body->begin(), frame.body->end()));
    }
    return list;
  }
  json answer_to(const char* text) {
    talk_.hear_text(text);
    const std::vector<json> list = answers();
    return list.empty() ? json() : list.back();
  }
  json answer_to(const Bytes& bytes, std::optional<TimePoint> sent_after) {
    talk_.hear_binary(bytes, sent_after);
    const std::vector<json> list = answers();
    return list.empty() ? json() : list.back();
  }
  static Published published(std::uint8_t byte) {
    return {5, std::make_shared<const Bytes>(3, byte)};
  }
  static Bytes on_channel(std::uint32_t channel, const Bytes& payload) {
    ByteWriter writer;
    writer.u8(1);
    writer.u32(channel);
    Bytes bytes = writer.bytes();
    append(bytes, payload);
    return bytes;
  }
  static Bytes call_of(Service service) {
    ByteWriter writer;
    writer.u8(2);
    writer.u32(static_cast<std::uint32_t>(service));
    writer.u32(9);
    writer.put_text("json");
    return writer.bytes();
  }

  HandClock clock_;
  RemotePilot pilot_{clock_, -0.2};
  Host host_;
  bool stopped_ = false;
  Conversation talk_{host_, 1};
};

TEST_F(FoxgloveTalk, BeginsWithWhatThereIs) {
  talk_.greet();
  const std::vector<json> said = answers();
  ASSERT_EQ(said.size(), 3U);
  EXPECT_EQ(said[0]["op"], "serverInfo");
  EXPECT_THAT(said[0]["capabilities"].dump(), HasSubstr("clientPublish"));
  EXPECT_EQ(said[1]["channels"].size(), channel_list().size());
  EXPECT_EQ(said[2]["services"].size(), 3U);
  host_.facts.drives = false;
  talk_.greet();
  EXPECT_THAT(answers()[0]["capabilities"].dump(), testing::Not(HasSubstr("clientPublish")));
}

TEST_F(FoxgloveTalk, TellsOnlyWhatIsSubscribedAndTheNewestAtOnce) {
  const auto task = static_cast<std::size_t>(Topic::task);
  host_.newest[task] = published(7);
  const std::string text =
      R"({"op":"subscribe","subscriptions":[{"id":40,"channelId":)" + std::to_string(task) + "}]}";
  talk_.hear_text(text);
  talk_.tell(Topic::odom, published(1));
  ASSERT_FALSE(talk_.queue().empty());
  const Frame frame = talk_.queue().pop();
  EXPECT_EQ((*frame.head)[0], 1);
  EXPECT_EQ((*frame.head)[1], 40);
  EXPECT_EQ((*frame.head)[5], 5);
  EXPECT_EQ(frame.body->front(), 7);
  EXPECT_TRUE(talk_.queue().empty());
  EXPECT_THAT(answer_to(text.c_str())["message"].dump(), HasSubstr("in use"));
  talk_.hear_text(R"({"op":"unsubscribe","subscriptionIds":[40]})");
  talk_.tell(Topic::task, published(8));
  EXPECT_TRUE(talk_.queue().empty());
  EXPECT_TRUE(talk_.wants().none());
}

TEST_F(FoxgloveTalk, ShowsSettingsAndChangesNone) {
  const json all = answer_to(R"({"op":"getParameters","parameterNames":[],"id":"a"})");
  EXPECT_EQ(all["id"], "a");
  EXPECT_EQ(all["parameters"][0]["value"], "0.5 m");
  EXPECT_EQ(all["parameters"][1]["value"], 3.0);
  EXPECT_EQ(
      answer_to(R"({"op":"getParameters","parameterNames":["x.count"]})")["parameters"].size(), 1U);
  talk_.hear_text(R"({"op":"setParameters","parameters":[{"name":"x.count","value":4}],"id":"b"})");
  const std::vector<json> said = answers();
  EXPECT_EQ(said[0]["op"], "status");
  EXPECT_EQ(said[1]["parameters"][1]["value"], 3.0);
}

TEST_F(FoxgloveTalk, PausesResumesAndStops) {
  answer_to(call_of(Service::pause), std::nullopt);
  ASSERT_TRUE(pilot_.wish(mission_ms(0)));
  EXPECT_EQ(pilot_.wish(mission_ms(0))->forward_m_s, 0.0);
  answer_to(call_of(Service::resume), std::nullopt);
  EXPECT_FALSE(pilot_.wish(mission_ms(100)));
  EXPECT_FALSE(stopped_);
  talk_.hear_binary(call_of(Service::stop), std::nullopt);
  EXPECT_TRUE(stopped_);
  const Frame frame = talk_.queue().pop();
  EXPECT_EQ(frame.body->front(), 3);
  EXPECT_EQ(json::parse(frame.body->begin() + 17, frame.body->end())["success"], true);
  EXPECT_EQ(answer_to(call_of(Service{77}), std::nullopt)["op"], "serviceCallFailure");
}

TEST_F(FoxgloveTalk, DrivesByEachFormOfATwist) {
  msgs::Twist twist;
  twist.linear.x = 0.3;
  twist.angular.z = -0.1;
  msgs::TwistStamped stamped;
  stamped.twist = twist;
  const std::string text = R"({"linear":{"x":0.3,"y":0,"z":0},"angular":{"x":0,"y":0,"z":-0.1}})";
  const std::string stamped_text = R"({"header":{},"twist":)" + text + "}";
  Bytes cdr;
  encode_cdr(twist, cdr);
  std::vector<std::tuple<const char*, const char*, Bytes>> forms = {
      {"cdr", "geometry_msgs/msg/Twist", cdr},
      {"json", "geometry_msgs/Twist", Bytes(text.begin(), text.end())},
      {"json", "geometry_msgs/msg/TwistStamped", Bytes(stamped_text.begin(), stamped_text.end())}};
  for (const char* frame : {"", "a", "base_link", "odometry"}) {
    stamped.header.frame_id = frame;
    encode_cdr(stamped, cdr);
    forms.emplace_back("cdr", "geometry_msgs/msg/TwistStamped", cdr);
  }
  std::uint32_t id = 0;
  for (const auto& [encoding, type, payload] : forms) {
    talk_.hear_text(json{
        {"op", "advertise"},
        {"channels",
         {{{"id", ++id}, {"topic", "/cmd_vel"}, {"encoding", encoding}, {"schemaName", type}}}}}
                        .dump());
    EXPECT_EQ(answer_to(on_channel(id, payload), clock_.time), json()) << type;
    const auto wish = pilot_.wish(mission_ms(0));
    ASSERT_TRUE(wish) << type << " in " << encoding;
    EXPECT_EQ(wish->forward_m_s, 0.3);
    EXPECT_EQ(wish->turn_rad_s, -0.1);
    pilot_.leave(1);
    for (std::size_t size = 0; size < payload.size(); ++size) {
      Bytes cut(payload.begin(), payload.begin() + static_cast<std::ptrdiff_t>(size));
      EXPECT_EQ(answer_to(on_channel(id, cut), clock_.time)["op"], "status") << type << size;
    }
    EXPECT_FALSE(pilot_.wish(mission_ms(0)));
  }
}

TEST_F(FoxgloveTalk, DrivesOnlyWhereItMayAndByCmdVelAlone) {
  const char* announce =
      R"({"op":"advertise","channels":[{"id":1,"topic":"/cmd_vel","encoding":"json",)"
      R"("schemaName":"geometry_msgs/msg/Twist"}]})";
  host_.facts.drives = false;
  EXPECT_THAT(answer_to(announce)["message"].dump(), HasSubstr("--foxglove-drive"));
  EXPECT_FALSE(talk_.drives());
  host_.facts.drives = true;
  EXPECT_THAT(answer_to(R"({"op":"advertise","channels":[{"id":1,"topic":"/x","encoding":"json",)"
                        R"("schemaName":"geometry_msgs/msg/Twist"}]})")["message"]
                  .dump(),
              HasSubstr("is not taken"));
  EXPECT_EQ(answer_to(announce), json());
  EXPECT_TRUE(talk_.drives());
  EXPECT_THAT(answer_to(on_channel(2, {}), clock_.time)["message"].dump(), HasSubstr("unknown"));
  const std::string twist = R"({"linear":{"x":1},"angular":{"z":0}})";
  // Before it is known how old its messages are, none drives.
  answer_to(on_channel(1, Bytes(twist.begin(), twist.end())), std::nullopt);
  EXPECT_FALSE(pilot_.wish(mission_ms(0)));
}

}  // namespace
}  // namespace striate::viewer::foxglove
