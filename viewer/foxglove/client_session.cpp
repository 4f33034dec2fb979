#include "striate/viewer/foxglove/client_session.hpp"

#include <algorithm>
#include <array>
#include <boost/beast/http/write.hpp>
#include <boost/beast/websocket/rfc6455.hpp>
#include <utility>

namespace striate::viewer::foxglove {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = boost::beast::http;
namespace websocket = boost::beast::websocket;

/// From connection to greeting, by hand: fifty round trips of a bad wireless line
constexpr auto kHandshakeTakes = std::chrono::seconds(5);
/// A client that has not even answered pings for so long has gone, by hand: a laptop that wakes
/// from a short sleep still finds its connection.
constexpr auto kSilenceLasts = std::chrono::seconds(60);
/// Of a request to upgrade, by hand: browsers send about 600 bytes
constexpr std::uint32_t kMostHeaderBytes = 8192;
/// Of what the page sends, by hand: names, and a region of an image
constexpr std::uint64_t kMostBodyBytes = 65536;
/// By hand: a recorded image over a bad wireless line
constexpr auto kAnswerTakes = std::chrono::seconds(60);
/// Nothing is loaded from elsewhere, nothing inline is run, no page of others shows or reads this.
constexpr std::array<std::pair<const char*, const char*>, 7> kGuards{{
    {"Content-Security-Policy",
     "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' blob: data:; "
     "connect-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'"},
    {"X-Content-Type-Options", "nosniff"},
    {"X-Frame-Options", "DENY"},
    {"Referrer-Policy", "no-referrer"},
    {"Cross-Origin-Opener-Policy", "same-origin"},
    {"Cross-Origin-Resource-Policy", "same-origin"},
    {"Cache-Control", "no-store"},
}};
/// Of a message from a client, by hand: eight times the list of all schemas of a Twist
constexpr std::size_t kMostMessageBytes = std::size_t{64} << 10U;
/// Messages a second, by hand: commands at 50 Hz, and a person who clicks about
constexpr double kMostRate_hz = 200.0;
constexpr double kMostAtOnce = 400.0;  // two seconds of them, by hand
/// That are read of a client, a second, by hand: four of the largest messages
constexpr std::size_t kMostBytesRead = 4 * kMostMessageBytes;
/// Of a client that drives, by hand: a fifth of the time that a command may drive
constexpr auto kPingEvery = std::chrono::milliseconds(100);

}  // namespace

bool MessageRate::take(TimePoint now) {
  const double passed_s = at_ ? to_seconds(now - *at_) : kMostAtOnce / kMostRate_hz;
  at_ = now;
  left_ = std::min(kMostAtOnce, left_ + passed_s * kMostRate_hz);
  left_ -= 1.0;
  return left_ >= 0.0;
}

ClientSession::ClientSession(asio::ip::tcp::socket socket, Host& host, const AccessRules& rules,
                             const Clock& clock, std::function<bool()> may_join)
    : stream_(std::move(socket)),
      ping_timer_(stream_.get_executor()),
      host_(host),
      rules_(rules),
      clock_(clock),
      may_join_(std::move(may_join)) {
  stream_.next_layer().rate_policy().read_limit(kMostBytesRead);
}

/// A handler that keeps the session alive, and ends it where the connection or memory fails.
template <class Handler>
auto ClientSession::mine(Handler handler) {
  return [self = shared_from_this(), handler = std::move(handler)](Error error, auto&&...) {
    if (error || self->gone_) return self->drop();
    try {
      handler(*self);
    } catch (...) {
      self->drop();
    }
  };
}

void ClientSession::start(std::uint64_t id) {
  id_ = id;
  parser_.emplace();
  parser_->header_limit(kMostHeaderBytes);
  parser_->body_limit(host_.site ? kMostBodyBytes : 0U);
  stream_.next_layer().expires_after(kHandshakeTakes);
  http::async_read(stream_.next_layer(), buffer_, *parser_,
                   mine([](ClientSession& self) { self.judge_handshake(); }));
}

void ClientSession::judge_handshake() {
  const auto& request = parser_->get();
  const auto text = [&request](http::field field) -> std::string_view {
    const auto value = request[field];
    return {value.data(), value.size()};
  };
  const boost::beast::string_view fetch_site = request["Sec-Fetch-Site"];
  const Handshake handshake{{request.target().data(), request.target().size()},
                            text(http::field::host),
                            text(http::field::origin),
                            text(http::field::cookie),
                            {fetch_site.data(), fetch_site.size()}};
  if (host_.site && !websocket::is_upgrade(request)) return show_page(handshake);
  const std::string why = why_refused(rules_, handshake);
  if (!why.empty()) return refuse(http::status::forbidden, why);
  if (!websocket::is_upgrade(request)) {
    return refuse(http::status::upgrade_required,
                  "here is a robot for Foxglove and Lichtblick: open this address there, as a "
                  "Foxglove WebSocket");
  }
  const auto subprotocol = choose_subprotocol(text(http::field::sec_websocket_protocol));
  if (!subprotocol) {
    return refuse(http::status::bad_request,
                  "the subprotocols foxglove.sdk.v1 and foxglove.websocket.v1 are spoken");
  }
  if (!may_join_()) {
    return refuse(http::status::service_unavailable, "as many viewers look as may");
  }
  open(*subprotocol);
}

/// A page, or what it asks for: one answer a connection.
void ClientSession::show_page(const Handshake& handshake) {
  const std::string why = why_page_refused(rules_, handshake);
  if (!why.empty()) return refuse(http::status::forbidden, why);
  const auto& request = parser_->get();
  const std::string target(handshake.target);
  const std::size_t path_ends = std::min(target.find('?'), target.size());
  const auto type = request[http::field::content_type];
  dashboard::HttpAnswer answer = host_.site->answer(
      {std::string(request.method_string()), target.substr(0, path_ends),
       target.substr(std::min(path_ends + 1, target.size())), std::string(type), request.body()});
  http::response<http::string_body> response(static_cast<http::status>(answer.status), 11);
  response.set(http::field::content_type, answer.type);
  if (const std::string cookie = cookie_for(rules_, handshake); !cookie.empty()) {
    response.set(http::field::set_cookie, cookie);
  }
  response.body() = std::move(answer.body);
  stream_.next_layer().expires_after(kAnswerTakes);
  send(std::move(response));
}

void ClientSession::refuse(http::status status, const std::string& why) {
  http::response<http::string_body> response(status, 11);
  response.set(http::field::content_type, "text/plain; charset=utf-8");
  if (status == http::status::upgrade_required) response.set(http::field::upgrade, "websocket");
  response.body() = why + "\n";
  send(std::move(response));
}

void ClientSession::send(http::response<http::string_body> answer) {
  const auto response = std::make_shared<http::response<http::string_body>>(std::move(answer));
  for (const auto& [name, value] : kGuards) response->set(name, value);
  response->keep_alive(false);
  response->prepare_payload();
  if (parser_->get().method() == http::verb::head) response->body().clear();
  http::async_write(stream_.next_layer(), *response, mine([response](ClientSession& self) {
                      Error ignored;
                      self.stream_.next_layer().socket().shutdown(
                          asio::ip::tcp::socket::shutdown_send, ignored);
                      self.drop();
                    }));
}

void ClientSession::open(std::string_view subprotocol) {
  stream_.next_layer().expires_never();
  stream_.set_option(websocket::stream_base::timeout{kHandshakeTakes, kSilenceLasts, true});
  stream_.set_option(websocket::stream_base::decorator(
      [name = std::string(subprotocol)](websocket::response_type& response) {
        response.set(http::field::sec_websocket_protocol, name);
      }));
  stream_.read_message_max(kMostMessageBytes);
  stream_.auto_fragment(false);  // else a picture goes out in pieces of 4 KB
  stream_.control_callback([this](websocket::frame_type kind, beast::string_view payload) {
    const bool answered = kind == websocket::frame_type::pong && pinged_at_ &&
                          payload == std::to_string(ping_number_);
    if (!answered) return;
    sent_after_ = pinged_at_;
    pinged_at_.reset();
  });
  talk_.emplace(host_, id_);
  stream_.async_accept(parser_->get(), mine([](ClientSession& self) {
                         self.open_ = true;
                         self.parser_.reset();
                         self.talk_->greet();
                         self.write_next();
                         self.read_next();
                       }));
}

void ClientSession::read_next() {
  buffer_.clear();
  stream_.async_read(buffer_, mine([](ClientSession& self) { self.heard(); }));
}

void ClientSession::heard() {
  if (closing_) return;
  if (!rate_.take(clock_.now())) return drop();
  const auto* data = static_cast<const std::uint8_t*>(buffer_.data().data());
  const ByteView bytes(data, buffer_.size());
  if (stream_.got_text()) {
    talk_->hear_text({reinterpret_cast<const char*>(data), bytes.size()});
  } else {
    talk_->hear_binary(bytes, sent_after_);
  }
  if (talk_->drives() && !pings_) {
    pings_ = true;
    ping();
  }
  write_next();
  if (!gone_) read_next();
}

void ClientSession::tell(Topic topic, const Published& message) {
  if (!joined() || ending_) return;
  talk_->tell(topic, message);
  write_next();
}

void ClientSession::tell_time(const std::shared_ptr<const Bytes>& message) {
  if (!joined() || ending_) return;
  talk_->tell_time(message);
  write_next();
}

void ClientSession::write_next() {
  if (!open_ || closing_ || gone_) return;
  if (talk_->hopeless()) return drop();
  if (in_hand_) return;
  if (talk_->queue().empty()) {
    if (ending_) say_good_bye();
    return;
  }
  in_hand_ = talk_->queue().pop();
  stream_.text(in_hand_->text);
  const std::array<asio::const_buffer, 2> pieces{
      in_hand_->head ? asio::buffer(*in_hand_->head) : asio::const_buffer(),
      asio::buffer(*in_hand_->body)};
  stream_.async_write(pieces, mine([](ClientSession& self) {
                        self.in_hand_.reset();
                        self.write_next();
                      }));
}

/// One ping is under way at a time. Answers come in the line of the client's messages: what comes
/// behind an answer was sent after the ping.
void ClientSession::ping() {
  if (!talk_->drives() || closing_) {
    pings_ = false;
    return;
  }
  if (pinged_at_) return ping_later();
  pinged_at_ = clock_.now();
  const std::string number = std::to_string(++ping_number_);
  stream_.async_ping(websocket::ping_data(number.c_str()),
                     mine([](ClientSession& self) { self.ping_later(); }));
}

void ClientSession::ping_later() {
  ping_timer_.expires_after(kPingEvery);
  ping_timer_.async_wait(mine([](ClientSession& self) { self.ping(); }));
}

void ClientSession::end() {
  ending_ = true;
  if (open_) return write_next();
  drop();
}

void ClientSession::say_good_bye() {
  closing_ = true;
  stream_.async_close(websocket::close_code::going_away,
                      mine([](ClientSession& self) { self.drop(); }));
}

void ClientSession::drop() {
  if (gone_) return;
  gone_ = true;
  talk_.reset();
  ping_timer_.cancel();
  beast::close_socket(beast::get_lowest_layer(stream_));
}

}  // namespace striate::viewer::foxglove
