#pragma once

#include <boost/asio/any_io_executor.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core/basic_stream.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/rate_policy.hpp>
#include <boost/beast/http/parser.hpp>
#include <boost/beast/http/string_body.hpp>
#include <boost/beast/websocket/stream.hpp>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "striate/viewer/foxglove/access.hpp"
#include "striate/viewer/foxglove/conversation.hpp"

namespace striate::viewer::foxglove {

/// So many messages a second may a client send, and somewhat more at once.
class MessageRate {
 public:
  /// @return false where that is a flood
  bool take(TimePoint now);

 private:
  double left_ = 0.0;
  std::optional<TimePoint> at_;
};

/// One connection, from its first byte to its end. All of it happens in the server's thread; what
/// a client does wrong ends its own connection and nothing else.
class ClientSession : public std::enable_shared_from_this<ClientSession> {
 public:
  /// @param may_join asked when the client is let in; false: there are enough
  ClientSession(boost::asio::ip::tcp::socket socket, Host& host, const AccessRules& rules,
                const Clock& clock, std::function<bool()> may_join);

  /// Reads the handshake and goes on from there. @param id no other client's
  void start(std::uint64_t id);
  void tell(Topic topic, const Published& message);
  void tell_time(const std::shared_ptr<const Bytes>& message);
  [[nodiscard]] TopicSet wants() const { return talk_ ? talk_->wants() : TopicSet(); }
  /// It has been let in and has not gone.
  [[nodiscard]] bool joined() const { return talk_.has_value() && !gone_; }
  [[nodiscard]] bool gone() const { return gone_; }
  /// Says what waits, then good-bye.
  void end();
  /// At once, without a word.
  void drop();

 private:
  using Error = boost::system::error_code;
  /// Reads no faster than it may: whatever floods, down to empty frames, waits in its own line.
  using LimitedStream =
      boost::beast::basic_stream<boost::asio::ip::tcp, boost::asio::any_io_executor,
                                 boost::beast::simple_rate_policy>;
  void judge_handshake();
  void show_page(const Handshake& handshake);
  void send(boost::beast::http::response<boost::beast::http::string_body> response);
  void refuse(boost::beast::http::status status, const std::string& why);
  void open(std::string_view subprotocol);
  void read_next();
  void heard();
  void write_next();
  void say_good_bye();
  void ping_later();
  void ping();
  template <class Handler>
  [[nodiscard]] auto mine(Handler handler);

  boost::beast::websocket::stream<LimitedStream> stream_;
  boost::asio::steady_timer ping_timer_;
  Host& host_;
  const AccessRules& rules_;
  const Clock& clock_;
  std::function<bool()> may_join_;
  std::uint64_t id_ = 0;
  boost::beast::flat_buffer buffer_;
  std::optional<boost::beast::http::request_parser<boost::beast::http::string_body>> parser_;
  std::optional<Conversation> talk_;
  std::optional<Frame> in_hand_;  ///< is being written
  MessageRate rate_;
  bool open_ = false;
  bool pings_ = false;
  std::uint64_t ping_number_ = 0;
  std::optional<TimePoint> pinged_at_;   ///< the ping that was not answered yet
  std::optional<TimePoint> sent_after_;  ///< of the last ping that was
  bool ending_ = false;
  bool closing_ = false;
  bool gone_ = false;
};

}  // namespace striate::viewer::foxglove
