#include "striate/platform/rosbridge/bridge_line.hpp"

#include <fcntl.h>
#include <fmt/format.h>

#include <boost/beast/core/stream_traits.hpp>
#include <boost/beast/websocket/error.hpp>
#include <boost/beast/websocket/rfc6455.hpp>
#include <utility>

namespace striate::rosbridge {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace websocket = boost::beast::websocket;

/// To connect, and then to be greeted, by hand: thirty round trips of a bad wireless line
constexpr auto kLineHandshakeTakes = std::chrono::seconds(3);
/// Messages that wait to be sent, by hand: all that is said at once are some ten greetings
constexpr std::size_t kMostWaiting = 64;

std::string plain_error(const boost::system::error_code& error) {
  if (error == websocket::error::closed) return "it closed the line";
  if (error == asio::error::eof || error == asio::error::connection_reset) {
    return "it hung up";
  }
  if (error == websocket::error::message_too_big) {
    return "its message is larger than rosbridge.most_message";
  }
  if (error == beast::error::timeout) return "it does not answer";
  return error.message();
}

}  // namespace

BridgeLine::BridgeLine(asio::io_context& io, BridgeAddress address, std::size_t most_message_bytes,
                       Hears hears)
    : stream_(io), address_(std::move(address)), hears_(std::move(hears)) {
  stream_.read_message_max(most_message_bytes);
  stream_.text(true);
}

/// A handler that keeps the line alive, and ends it where something fails.
template <class Handler>
auto BridgeLine::mine(const char* doing, Handler handler) {
  return [self = shared_from_this(), doing, handler = std::move(handler)](Error error, auto&&...) {
    if (self->gone_) return;
    if (error) return self->drop(fmt::format("{}{}", doing, plain_error(error)));
    try {
      handler(*self);
    } catch (const std::exception& failure) {
      self->drop(failure.what());
    }
  };
}

void BridgeLine::connect(const Endpoints& endpoints) {
  stream_.next_layer().expires_after(kLineHandshakeTakes);
  stream_.next_layer().async_connect(endpoints,
                                     mine("", [](BridgeLine& self) { self.shake_hands(); }));
}

void BridgeLine::shake_hands() {
  auto& tcp = stream_.next_layer();
  ::fcntl(tcp.socket().native_handle(), F_SETFD, FD_CLOEXEC);
  Error ignored;
  tcp.socket().set_option(asio::ip::tcp::no_delay(true), ignored);
  tcp.expires_never();
  stream_.set_option(
      websocket::stream_base::timeout{kLineHandshakeTakes, websocket::stream_base::none(), false});
  stream_.set_option(websocket::stream_base::decorator([](websocket::request_type& request) {
    request.set(beast::http::field::user_agent, "striate");
  }));
  stream_.control_callback([this](websocket::frame_type kind, beast::string_view) {
    if (kind == websocket::frame_type::pong) hears_.answered();
  });
  stream_.async_handshake(
      address_.host_field(), address_.path,
      mine("it greets like no rosbridge server: ", [](BridgeLine& self) { self.opened(); }));
}

void BridgeLine::opened() {
  open_ = true;
  hears_.opened();
  read_next();
  write_next();
}

void BridgeLine::read_next() {
  buffer_.clear();
  stream_.async_read(buffer_, mine("", [](BridgeLine& self) {
                       const auto* data = static_cast<const char*>(self.buffer_.data().data());
                       self.hears_.message({data, self.buffer_.size()});
                       if (!self.gone_) self.read_next();
                     }));
}

void BridgeLine::say(std::string message) {
  if (!open_ || closing_ || waiting_.size() >= kMostWaiting) return;
  waiting_.push_back(std::move(message));
  write_next();
}

void BridgeLine::say_newest(std::string message) {
  if (!open_ || closing_) return;
  newest_ = std::move(message);
  write_next();
}

void BridgeLine::write_next() {
  if (!open_ || writing_ || gone_) return;
  if (!waiting_.empty()) {
    in_hand_ = std::move(waiting_.front());
    waiting_.pop_front();
  } else if (newest_) {
    in_hand_ = std::move(*newest_);
    newest_.reset();
  } else {
    if (closing_) close();
    return;
  }
  writing_ = true;
  stream_.async_write(asio::buffer(in_hand_), mine("", [](BridgeLine& self) {
                        self.writing_ = false;
                        self.write_next();
                      }));
}

void BridgeLine::close() {
  writing_ = true;
  stream_.async_close(websocket::close_code::normal,
                      mine("", [](BridgeLine& self) { self.drop("the line was closed"); }));
}

void BridgeLine::ping() {
  if (!open_ || closing_ || pinging_ || gone_) return;
  pinging_ = true;
  stream_.async_ping({}, mine("", [](BridgeLine& self) { self.pinging_ = false; }));
}

void BridgeLine::say_good_bye(std::vector<std::string> last_words) {
  newest_.reset();  // a command that waits must not come behind the last one
  for (std::string& word : last_words) waiting_.push_back(std::move(word));
  closing_ = true;
  write_next();
}

void BridgeLine::drop(const std::string& why) {
  if (gone_) return;
  gone_ = true;
  open_ = false;
  beast::close_socket(beast::get_lowest_layer(stream_));
  hears_.gone(why);
}

}  // namespace striate::rosbridge
