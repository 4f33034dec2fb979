#include "striate/platform/served/served_line.hpp"

#include <fmt/format.h>
#include <poll.h>

#include <array>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/posix/stream_descriptor.hpp>
#include <boost/asio/write.hpp>
#include <chrono>
#include <optional>
#include <stdexcept>

#include "striate/platform/served/pseudo_terminal.hpp"

namespace striate::served {
namespace {

namespace asio = boost::asio;
using boost::system::error_code;
using Tcp = asio::ip::tcp;
using Steady = std::chrono::steady_clock;

/// It has closed its end, whatever it had said before.
bool has_hung_up(Tcp::socket& socket) {
  pollfd looked{socket.native_handle(), POLLRDHUP, 0};
  return ::poll(&looked, 1, 0) > 0;
}

}  // namespace

struct ServedLine::Parts {
  Parts(asio::io_context& io, ServedPlace place_in, Events events_in)
      : place(std::move(place_in)),
        events(std::move(events_in)),
        acceptor(io),
        client(io),
        next(io),
        terminal(io) {}

  void listen();
  void open_terminal();
  void accept();
  void take(Tcp::socket socket);
  void greet(Tcp::socket socket);
  void let_go(const std::string& why);
  void call_next();
  void tend();
  void tend_client(Steady::time_point now);
  /// Longer than a client that says nothing is borne, so that whoever waits behind it is served.
  [[nodiscard]] Steady::duration most_waiting_time() const { return place.idle_limit * 5 / 4; }
  template <class Stream>
  void read_on(Stream& stream);
  template <class Stream>
  void write_on(Stream& stream);
  void log(const std::string& line) const { events.log(place.name + ": " + line); }

  ServedPlace place;
  Events events;
  Tcp::acceptor acceptor;
  Tcp::socket client;
  Tcp::socket next;  ///< waits for the client to go; closed: nobody does
  Steady::time_point next_since;
  Steady::time_point last_word;  ///< of the client, or of the device's stream
  Steady::time_point write_began;
  std::uint64_t words_at_first = 0;
  std::uint64_t words = 0;
  asio::posix::stream_descriptor terminal;
  std::optional<PseudoTerminal> pty;
  std::string url;

  bool has_client = false;
  std::uint64_t generation = 0;
  std::array<std::uint8_t, 1024> chunk{};
  Bytes outbox;
  Bytes under_way;
  bool writing = false;
};

void ServedLine::Parts::listen() {
  error_code error;
  const auto address = asio::ip::make_address(place.address, error);
  if (error) throw std::runtime_error(place.address + ": is no address");
  const Tcp::endpoint end(address, static_cast<std::uint16_t>(place.port));
  acceptor.open(end.protocol());
  acceptor.set_option(Tcp::acceptor::reuse_address(true));
  acceptor.bind(end, error);
  if (!error) acceptor.listen(4, error);
  if (error) {
    throw std::runtime_error(fmt::format("{}:{} for the {}: {}", place.address, place.port,
                                         place.name, error.message()));
  }
  url = fmt::format("tcp://{}:{}", place.address, acceptor.local_endpoint().port());
  accept();
}

void ServedLine::Parts::open_terminal() {
  pty.emplace();
  terminal.assign(pty->release_master());
  url = "pty:" + pty->name();
  has_client = true;
  events.connected();
  read_on(terminal);
}

void ServedLine::Parts::accept() {
  acceptor.async_accept([this](const error_code& error, Tcp::socket socket) {
    const bool gone = error == boost::asio::error::connection_aborted;
    if (error && !gone) {
      if (error != boost::asio::error::operation_aborted)
        log("no more clients are taken: " + error.message());
      return;
    }
    if (gone) {
      log("a client went before it was taken");
    } else {
      take(std::move(socket));
    }
    accept();
  });
}

void ServedLine::Parts::take(Tcp::socket socket) {
  if (next.is_open() && has_hung_up(next)) next.close();
  if (!has_client) return greet(std::move(socket));
  if (next.is_open()) return log("a third client was turned away");
  next = std::move(socket);
  next_since = Steady::now();
  log("a second client waits");
}

void ServedLine::Parts::greet(Tcp::socket socket) {
  client = std::move(socket);
  error_code ignored;
  client.set_option(Tcp::no_delay(true), ignored);
  has_client = true;
  outbox.clear();
  writing = false;
  log("a client has connected");
  events.connected();
  last_word = Steady::now();
  words = words_at_first = events.dealings().understood;
  read_on(client);
}

void ServedLine::Parts::let_go(const std::string& why) {
  if (!has_client || pty) return;
  has_client = false;
  ++generation;
  error_code ignored;
  client.close(ignored);
  log("the client is gone: " + why);
  call_next();
}

/// What somebody said who has hung up since is not obeyed.
void ServedLine::Parts::call_next() {
  if (has_client || !next.is_open()) return;
  if (has_hung_up(next)) {
    error_code ignored;
    next.close(ignored);
    log("the second client went before it was its turn");
    return;
  }
  greet(std::move(next));
}

void ServedLine::Parts::tend() {
  if (pty) return;
  const Steady::time_point now = Steady::now();
  if (has_client) tend_client(now);
  if (!next.is_open() || now - next_since <= most_waiting_time()) return;
  error_code ignored;
  next.close(ignored);
  log("the second client was turned away: the first one works on");
}

void ServedLine::Parts::tend_client(Steady::time_point now) {
  if (writing && now - write_began > place.idle_limit) return let_go("it does not read");
  const Dealings dealings = events.dealings();
  if (dealings.understood != words || dealings.streams) last_word = now;
  words = dealings.understood;
  if (now - last_word <= place.idle_limit) return;
  const bool spoke = words != words_at_first;
  if (!spoke || next.is_open()) let_go("it says nothing");
}

template <class Stream>
void ServedLine::Parts::read_on(Stream& stream) {
  stream.async_read_some(asio::buffer(chunk), [this, &stream, now = generation](
                                                  const error_code& error, std::size_t size) {
    if (now != generation) return;
    if (error) return let_go(error.message());
    events.received(ByteView(chunk).first(size));
    read_on(stream);
  });
}

template <class Stream>
void ServedLine::Parts::write_on(Stream& stream) {
  writing = true;
  write_began = Steady::now();
  under_way.swap(outbox);
  outbox.clear();
  asio::async_write(stream, asio::buffer(under_way),
                    [this, &stream, now = generation](const error_code& error, std::size_t) {
                      if (now != generation) return;
                      writing = false;
                      if (error) return let_go(error.message());
                      if (!outbox.empty()) write_on(stream);
                    });
}

ServedLine::ServedLine(asio::io_context& io, ServedPlace place, Events events)
    : parts_(std::make_unique<Parts>(io, std::move(place), std::move(events))) {
  if (parts_->place.pty) {
    parts_->open_terminal();
  } else {
    parts_->listen();
  }
}

ServedLine::~ServedLine() = default;

const std::string& ServedLine::url() const {
  return parts_->url;
}

bool ServedLine::has_client() const {
  return parts_->has_client;
}

bool ServedLine::idle() const {
  return !parts_->writing && parts_->outbox.empty();
}

void ServedLine::tend() {
  parts_->tend();
}

void ServedLine::let_go(const std::string& why) {
  parts_->let_go(why);
}

void ServedLine::write(Bytes bytes) {
  if (bytes.empty() || !has_client()) return;
  if (parts_->outbox.empty()) {
    parts_->outbox.swap(bytes);
  } else {
    append(parts_->outbox, bytes);
  }
  if (parts_->outbox.size() > parts_->place.most_waiting) {
    parts_->outbox.clear();
    return let_go("it asks for more than the line takes, or does not read");
  }
  if (parts_->writing) return;
  if (parts_->pty) {
    parts_->write_on(parts_->terminal);
  } else {
    parts_->write_on(parts_->client);
  }
}

}  // namespace striate::served
