#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <boost/asio/read.hpp>
#include <boost/asio/write.hpp>
#include <deque>

#include "striate/base/user_error.hpp"
#include "tests/unit/viewer/foxglove_viewer.hpp"

/// The server behind real sockets, viewers that mean well before it.
namespace striate::viewer::foxglove {
namespace {

TEST_F(FoxgloveServerTest, SpeaksBothSubprotocols) {
  for (const char* protocol : {"foxglove.sdk.v1", "foxglove.websocket.v1"}) {
    Viewer viewer(connect(), protocol);
    EXPECT_EQ(viewer.answer[beast::http::field::sec_websocket_protocol], protocol);
    EXPECT_EQ(viewer.hear_json()["op"], "serverInfo");
    EXPECT_EQ(viewer.hear_json()["op"], "advertise");
    EXPECT_EQ(viewer.hear_json()["op"], "advertiseServices");
  }
}

TEST_F(FoxgloveServerTest, RefusesWhoMayNotLookAndWhatIsNoViewer) {
  EXPECT_THROW(Viewer(connect(), "chat"), boost::system::system_error);
  EXPECT_THROW(Viewer(connect(), "foxglove.sdk.v1", "https://evil.example"),
               boost::system::system_error);
  for (const auto& [request, status] : std::vector<std::pair<std::string, std::string>>{
           {"GET / HTTP/1.1\r\nHost: evil.example\r\n\r\n", "HTTP/1.1 403"},
           {"GET / HTTP/1.1\r\nHost: localhost\r\nOrigin: null\r\n\r\n", "HTTP/1.1 403"},
           {"GET / HTTP/1.1\r\nHost: localhost\r\n\r\n", "HTTP/1.1 426"}}) {
    tcp::socket socket = connect();
    asio::write(socket, asio::buffer(request));
    std::string answer;
    boost::system::error_code end;
    asio::read(socket, asio::dynamic_buffer(answer), end);
    EXPECT_EQ(answer.substr(0, status.size()), status) << request << answer;
  }
}

TEST_F(FoxgloveServerTest, TellsCyclesAndTheNewestOfSlowThingsToWhoComesLate) {
  ASSERT_TRUE(cycle(1));
  Viewer early(connect());
  early.subscribe(Topic::battery, 3);
  EXPECT_FALSE(early.hear_from(3).empty());
  early.subscribe(Topic::cycle, 4);
  early.say(json{{"op", "getParameters"}, {"parameterNames", json::array()}, {"id", "now"}});
  while (early.hear_json()["op"] != "parameterValues") {
  }
  ASSERT_TRUE(cycle(2));
  EXPECT_EQ(json::parse(early.hear_from(4))["number"], 2);
}

TEST_F(FoxgloveServerTest, AViewerDrivesWhileItAnswersPingsAndNoLonger) {
  {
    Viewer viewer(connect());
    viewer.say(json{{"op", "advertise"},
                    {"channels",
                     {{{"id", 1},
                       {"topic", "/cmd_vel"},
                       {"encoding", "json"},
                       {"schemaName", "geometry_msgs/msg/Twist"}}}}});
    const std::string twist = R"({"linear":{"x":0.3},"angular":{"z":0.1}})";
    Bytes message{1, 1, 0, 0, 0};
    message.insert(message.end(), twist.begin(), twist.end());
    const auto wish = [&] { return server_.pilot().wish(TimePoint()); };
    viewer.say(message);
    std::this_thread::sleep_for(50ms);
    EXPECT_FALSE(wish());  // nobody knows how old it is: no ping was answered
    EXPECT_TRUE(comes_true([&] {
      viewer.say(json{{"op", "getParameters"}, {"parameterNames", json::array()}});
      while (viewer.hear_json()["op"] != "parameterValues") {  // reading answers pings
      }
      viewer.say(message);
      return wish().has_value();
    }));
    // It sends on, but no answers any more: as what has waited on a line would come.
    EXPECT_TRUE(comes_true([&] {
      viewer.say(message);
      return !wish();
    }));
    viewer.say(message);
    std::this_thread::sleep_for(50ms);
    EXPECT_FALSE(wish());
  }
  ASSERT_TRUE(comes_true([&] { return cycle(1), server_.clients() == 0; }));
}

TEST_F(FoxgloveServerTest, SaysTheLastThingsAndGoodBye) {
  Viewer viewer(connect());
  viewer.subscribe(Topic::cycle, 2);
  viewer.say(json{{"op", "getParameters"}, {"parameterNames", json::array()}});
  while (viewer.hear_json()["op"] != "parameterValues") {
  }
  ASSERT_TRUE(cycle(9));
  std::thread end([this] { server_.finish(); });
  EXPECT_EQ(json::parse(viewer.hear_from(2))["number"], 9);
  try {
    while (true) viewer.hear();
  } catch (const boost::system::system_error& error) {
    EXPECT_EQ(error.code(), websocket::error::closed);
  }
  end.join();
  EXPECT_FALSE(cycle(10) && cycle(11) && cycle(12) && cycle(13) && cycle(14));
}

TEST_F(FoxgloveServerTest, EndsThoughNobodyReads) {
  Viewer deaf(connect());
  deaf.subscribe(Topic::left_image, 1);
  deaf.say(json{{"op", "getParameters"}, {"parameterNames", json::array()}});
  while (deaf.hear_json()["op"] != "parameterValues") {
  }
  for (std::uint64_t k = 1; k <= 20; ++k) comes_true([&] { return cycle(k, 500); });
  const auto began = std::chrono::steady_clock::now();
  server_.finish();
  EXPECT_LT(std::chrono::steady_clock::now() - began, 5s);  // half a second, on an idle machine
}

TEST_F(FoxgloveServerTest, APortInUseAndAnAddressOfOthersAreToldAtOnce) {
  const Channels channels(RobotDescription{}, tasks::Task{});
  try {
    FoxgloveServer second(options_for("127.0.0.1", endpoint().port()), {}, channels);
    ADD_FAILURE() << "two servers on one port";
  } catch (const UserError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("Address already in use"));
    EXPECT_THAT(error.what(), testing::HasSubstr("--foxglove 0"));
  }
  EXPECT_THROW(FoxgloveServer(options_for("robot", 0), {}, channels), UserError);
  EXPECT_THROW(FoxgloveServer(options_for("192.0.2.1", 0), {}, channels), UserError);
  const FoxgloveServer open(options_for("0.0.0.0", 0), {}, channels);
  EXPECT_THAT(open.url(), testing::HasSubstr("/?token="));
}

}  // namespace
}  // namespace striate::viewer::foxglove
