#pragma once

#include <gtest/gtest.h>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core/buffers_to_string.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/http/string_body.hpp>
#include <boost/beast/websocket/stream.hpp>
#include <nlohmann/json.hpp>
#include <thread>

#include "striate/viewer/foxglove/foxglove_server.hpp"

/// A server behind real sockets, and a viewer before it.
namespace striate::viewer::foxglove {

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

inline ServerOptions options_for(const std::string& address, std::uint16_t port) {
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

}  // namespace striate::viewer::foxglove
