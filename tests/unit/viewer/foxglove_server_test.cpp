#include "striate/viewer/foxglove/foxglove_server.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/read.hpp>
#include <boost/asio/write.hpp>
#include <boost/beast/core/buffers_to_string.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/http/string_body.hpp>
#include <boost/beast/websocket/stream.hpp>
#include <deque>
#include <nlohmann/json.hpp>
#include <thread>

#include "striate/base/user_error.hpp"

/// The server behind real sockets, honest and hostile clients before it.
namespace striate::viewer::foxglove {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace websocket = boost::beast::websocket;
using asio::ip::tcp;
using nlohmann::json;
using namespace std::chrono_literals;

/// Waits at most as long as a busy machine needs.
template <class Condition>
bool comes_true(Condition condition) {
  for (int k = 0; k < 2000; ++k) {
    if (condition()) return true;
    std::this_thread::sleep_for(5ms);
  }
  return false;
}

ServerOptions options_for(const std::string& address, std::uint16_t port) {
  ServerOptions options;
  options.address = address;
  options.port = port;
  options.drives = true;
  return options;
}

class FoxgloveServerTest : public testing::Test {
 protected:
  FoxgloveServerTest()
      : server_(options_for("127.0.0.1", 0), ServerFacts(),
                Channels(RobotDescription{}, tasks::Task{})) {}

  [[nodiscard]] tcp::endpoint endpoint() const {
    const std::string& url = server_.url();
    const auto port = static_cast<std::uint16_t>(std::stoi(url.substr(url.rfind(':') + 1)));
    return {asio::ip::make_address("127.0.0.1"), port};
  }
  tcp::socket connect() {
    tcp::socket socket(io_);
    socket.connect(endpoint());
    return socket;
  }
  /// Tells the facts of a cycle, where there is room.
  bool cycle(std::uint64_t number, int image_side = 0) {
    return server_.put([&](CycleFacts& facts) {
      facts = {};
      facts.number = number;
      facts.senses.now = TimePoint(std::chrono::milliseconds(100 * number));
      facts.slow_is_new = true;
      facts.senses.stereo.stamp = facts.senses.now;
      if (image_side == 0) return;
      facts.new_image = true;
      facts.senses.stereo.left = cv::Mat3b(image_side, image_side);
      cv::randu(facts.senses.stereo.left, 0, 255);
    });
  }

  asio::io_context io_;
  FoxgloveServer server_;
};

struct Viewer {
  explicit Viewer(tcp::socket socket, const std::string& protocol = "foxglove.sdk.v1",
                  const std::string& origin = "")
      : stream(std::move(socket)) {
    stream.set_option(websocket::stream_base::decorator([&](websocket::request_type& request) {
      request.set(beast::http::field::sec_websocket_protocol, protocol);
      if (!origin.empty()) request.set(beast::http::field::origin, origin);
    }));
    stream.handshake(answer, "localhost", "/");
  }
  void say(const json& text) {
    stream.text(true);
    stream.write(asio::buffer(text.dump()));
  }
  void say(const Bytes& bytes) {
    stream.binary(true);
    stream.write(asio::buffer(bytes));
  }
  std::string hear() {
    beast::flat_buffer buffer;
    stream.read(buffer);
    return beast::buffers_to_string(buffer.data());
  }
  json hear_json() {
    while (true) {
      const std::string text = hear();
      if (stream.got_text()) return json::parse(text);
    }
  }
  /// The next message of the subscription, past the time and others; its payload.
  std::string hear_from(std::uint8_t subscription) {
    while (true) {
      const std::string text = hear();
      if (!stream.got_text() && text[0] == 1 && text[1] == static_cast<char>(subscription)) {
        return text.substr(13);
      }
    }
  }
  void subscribe(Topic topic, std::uint32_t id) {
    say(json{{"op", "subscribe"},
             {"subscriptions", {{{"id", id}, {"channelId", static_cast<unsigned>(topic)}}}}});
  }
  websocket::response_type answer;
  websocket::stream<tcp::socket> stream;
};

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

TEST_F(FoxgloveServerTest, OneThatNeverReadsHoldsUpNobody) {
  std::vector<std::unique_ptr<Viewer>> deaf;
  for (int k = 0; k < 3; ++k) {
    deaf.push_back(std::make_unique<Viewer>(connect()));
    deaf.back()->subscribe(Topic::left_image, 1);
    deaf.back()->subscribe(Topic::cycle, 2);
  }
  Viewer viewer(connect());
  viewer.subscribe(Topic::cycle, 2);
  viewer.say(json{{"op", "getParameters"}, {"parameterNames", json::array()}, {"id", "now"}});
  while (viewer.hear_json()["op"] != "parameterValues") {
  }
  for (std::uint64_t number = 1; number <= 60; ++number) {  // 0.75 MB each: more than any buffer
    ASSERT_TRUE(comes_true([&] { return cycle(number, 500); }));
    EXPECT_EQ(json::parse(viewer.hear_from(2))["number"], number);
  }
  EXPECT_EQ(server_.clients(), 4U);
  // Who reads again gets the newest.
  while (json::parse(deaf[0]->hear_from(2))["number"] != 60) {
  }
}

TEST_F(FoxgloveServerTest, AFloodEndsItsOwnConnectionOnly) {
  Viewer viewer(connect());
  Viewer flood(connect());
  EXPECT_THROW(
      {
        for (int k = 0; k < 1'000'000; ++k) flood.say(json{{"op", "nonsense"}});
      },
      boost::system::system_error);
  // Another one reads what it is answered.
  Viewer reader(connect());
  EXPECT_THROW(
      {
        for (int k = 0; k < 10'000; ++k) {
          reader.say(json{{"op", "nonsense"}});
          reader.hear();
        }
      },
      boost::system::system_error);
  viewer.say(json{{"op", "getParameters"}, {"parameterNames", json::array()}, {"id", "now"}});
  while (viewer.hear_json()["op"] != "parameterValues") {
  }
  ASSERT_TRUE(comes_true([&] { return cycle(1), server_.clients() == 1; }));
}

TEST_F(FoxgloveServerTest, FloodsOfPingsAndEmptyFramesWaitInTheirOwnLine) {
  // Pings, and a binary message that goes on in empty pieces and never ends.
  for (const Bytes& frame : {Bytes{0x89, 0x80, 1, 2, 3, 4}, Bytes{0x00, 0x80, 1, 2, 3, 4}}) {
    Viewer flood(connect());
    if (frame[0] == 0)
      asio::write(flood.stream.next_layer(), asio::buffer(Bytes{0x02, 0x80, 1, 2, 3, 4}));
    Bytes many;
    for (int k = 0; k < 10'000; ++k) append(many, frame);
    flood.stream.next_layer().non_blocking(true);
    // First what the line itself holds; then what is read of it in a second.
    std::size_t sent = 0;
    for (const auto lasts : {500ms, 1000ms}) {
      sent = 0;
      const auto until = std::chrono::steady_clock::now() + lasts;
      while (std::chrono::steady_clock::now() < until) {
        boost::system::error_code full;
        sent += flood.stream.next_layer().write_some(asio::buffer(many), full);
        if (full) std::this_thread::sleep_for(1ms);
        Bytes answers(100'000);
        flood.stream.next_layer().read_some(asio::buffer(answers), full);
      }
    }
    EXPECT_LT(sent, std::size_t{1} << 20U) << "in a second";
    Viewer viewer(connect());
    EXPECT_EQ(viewer.hear_json()["op"], "serverInfo");
  }
}

TEST_F(FoxgloveServerTest, AGiantMessageEndsItsOwnConnectionOnly) {
  Viewer giant(connect());
  try {
    giant.say(Bytes(std::size_t{4} << 20U));
    while (true) giant.hear();
  } catch (const boost::system::system_error&) {
  }
  // And one that only claims to be giant: FIN, binary, masked, 2^62 bytes.
  Viewer liar(connect());
  const Bytes head{0x82, 0xff, 0x40, 0, 0, 0, 0, 0, 0, 0, 1, 2, 3, 4};
  asio::write(liar.stream.next_layer(), asio::buffer(head));
  try {
    while (true) liar.hear();
  } catch (const boost::system::system_error&) {
  }
  Viewer viewer(connect());
  EXPECT_EQ(viewer.hear_json()["op"], "serverInfo");
}

TEST_F(FoxgloveServerTest, GarbageAndHalfOpenConnectionsKeepNobodyOut) {
  std::deque<tcp::socket> half_open;
  for (int k = 0; k < 100; ++k) {
    half_open.push_back(connect());
    if (k % 2 == 0) asio::write(half_open.back(), asio::buffer("GET / HTTP/1.1\r\nX: ", 20));
  }
  for (const std::string& garbage :
       {std::string(100'000, '\xff'), std::string("\x16\x03\x01\x02", 4),
        "GET / HTTP/1.1\r\n" + std::string(20'000, 'a') + ": b\r\n\r\n"}) {
    tcp::socket socket = connect();
    boost::system::error_code ignored;
    asio::write(socket, asio::buffer(garbage), ignored);
  }
  Viewer viewer(connect());
  EXPECT_EQ(viewer.hear_json()["op"], "serverInfo");
}

TEST_F(FoxgloveServerTest, MoreViewersThanMayAreToldSo) {
  std::vector<std::unique_ptr<Viewer>> viewers;
  for (std::size_t k = 0; k < FoxgloveServer::kMostClients; ++k) {
    viewers.push_back(std::make_unique<Viewer>(connect()));
    viewers.back()->hear_json();
  }
  EXPECT_THROW(Viewer{connect()}, boost::system::system_error);
  viewers.pop_back();
  EXPECT_TRUE(comes_true([&] {
    try {
      Viewer viewer(connect());
      return true;
    } catch (const boost::system::system_error&) {
      return false;
    }
  }));
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
