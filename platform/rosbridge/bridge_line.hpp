#pragma once

#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/websocket/stream.hpp>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "striate/platform/rosbridge/bridge_address.hpp"

namespace striate::rosbridge {

/// One connection to a rosbridge server, from the first packet to its end, in the thread that runs
/// `io`.
class BridgeLine : public std::enable_shared_from_this<BridgeLine> {
 public:
  struct Hears {
    std::function<void()> opened;
    std::function<void(std::string_view message)> message;
    std::function<void()> answered;                    ///< the server lives
    std::function<void(const std::string& why)> gone;  ///< once, as the last of all
  };
  using Endpoints = boost::asio::ip::tcp::resolver::results_type;

  BridgeLine(boost::asio::io_context& io, BridgeAddress address, std::size_t most_message_bytes,
             Hears hears);
  void connect(const Endpoints& endpoints);
  void say(std::string message);
  void say_newest(std::string message);
  /// Asks whether the server is there; one question at a time is under way.
  void ping();
  /// Says these after what waits, in place of the newest, then closes. On an open line.
  void say_good_bye(std::vector<std::string> last_words);
  /// Ends at once. @param why in plain words
  void drop(const std::string& why);
  [[nodiscard]] bool is_open() const { return open_; }

 private:
  using Error = boost::system::error_code;
  template <class Handler>
  auto mine(const char* doing, Handler handler);
  void shake_hands();
  void opened();
  void read_next();
  void write_next();
  void close();

  boost::beast::websocket::stream<boost::beast::tcp_stream> stream_;
  BridgeAddress address_;
  Hears hears_;
  boost::beast::flat_buffer buffer_;
  std::deque<std::string> waiting_;
  std::optional<std::string> newest_;
  std::string in_hand_;
  bool writing_ = false;
  bool pinging_ = false;
  bool open_ = false;
  bool closing_ = false;
  bool gone_ = false;
};

}  // namespace striate::rosbridge
