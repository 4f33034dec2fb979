#include <fcntl.h>

#include <array>
#include <boost/asio/connect.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/local/stream_protocol.hpp>
#include <boost/asio/serial_port.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/write.hpp>
#include <optional>
#include <system_error>
#include <thread>

#include "striate/platform/pioneer/keeper/kept_line.hpp"
#include "striate/platform/pioneer/transport.hpp"
#include "striate/platform/pioneer/transport_url.hpp"

namespace striate::pioneer {
namespace {

namespace asio = boost::asio;
using boost::system::error_code;
using Tcp = asio::ip::tcp;

/// A line that has so much waiting takes nothing any more: some 700 ms at 115200 baud.
/// Bytes: a line that has so much waiting takes nothing any more: some 700 ms at 115200 baud
constexpr std::size_t kMostWaiting = 8192;
/// For the last bytes at closing: 57 of them at 9600 baud, a stop and a CLOSE
constexpr auto kFlush = std::chrono::milliseconds(60);
/// A host in the same building answers within one lost SYN, sent again after 1 s
constexpr auto kConnectPatience = std::chrono::seconds(3);

/// What TCP and serial have in common. All of it runs in the thread that calls.
template <class Stream>
class StreamLine : public Transport {
 public:
  StreamLine(TransportUrl url, bool kept)
      : url_(std::move(url)), stream_(io_), kept_(kept), end_(io_) {}

  void open() override {
    close();
    trouble_.clear();
    begin_open();
  }
  void close() override {
    if (open_ && writing_) {
      io_.restart();
      io_.run_for(kFlush);
    }
    shut();
  }
  [[nodiscard]] bool is_opening() const override { return opening_; }
  [[nodiscard]] bool is_open() const override { return open_; }
  [[nodiscard]] std::string trouble() const override { return trouble_; }

  [[nodiscard]] Bytes read() override {
    io_.restart();
    io_.poll();
    Bytes bytes;
    bytes.swap(inbox_);
    return bytes;
  }
  void write(ByteView bytes) override {
    append(outbox_, bytes);
    if (outbox_.size() > kMostWaiting) {
      fail("it takes no more bytes");
    } else if (!writing_) {
      write_on();
    }
  }
  void wait(Duration at_most) override {
    if (!open_ && !opening_) {
      std::this_thread::sleep_for(at_most);  // nothing is under way that could come
      return;
    }
    io_.restart();
    if (io_.run_one_for(at_most) > 0) io_.poll();
  }

 protected:
  virtual void begin_open() = 0;
  virtual void end_open() {}
  /// Takes the open line's descriptor out of the stream. @throws std::system_error
  virtual int take_descriptor() = 0;

  void opened() {
    try {
      if (kept_) have_it_kept();
    } catch (const std::system_error& error) {
      return fail(error.what());  // nobody would stop the robot if this program died
    }
    opening_ = false;
    open_ = true;
    kept_ ? read_on(end_) : read_on(stream_);
  }
  void fail(const std::string& why) {
    shut();
    trouble_ = why;
  }
  void shut() {
    end_open();
    error_code ignored;
    stream_.close(ignored);
    if (keeper_) keeper_->let_go([&] { end_.close(ignored); });
    keeper_.reset();
    open_ = opening_ = writing_ = false;
    ++generation_;
    inbox_.clear();
    outbox_.clear();
  }
  /// Handlers of a stream that has been closed since must not speak for the next one.
  template <class Handler>
  auto current(Handler handler) {
    return [this, handler, generation = generation_](const error_code& error, auto&&... rest) {
      if (generation == generation_) handler(error, rest...);
    };
  }

  TransportUrl url_;
  asio::io_context io_{1};
  Stream stream_;
  bool opening_ = false;

 private:
  void have_it_kept() {
    keeper_.emplace(take_descriptor());
    end_.assign(asio::local::stream_protocol(), keeper_->release_end());
  }
  template <class Line>
  void read_on(Line& line) {
    line.async_read_some(asio::buffer(chunk_),
                         current([this, &line](const error_code& error, std::size_t size) {
                           if (error) return fail(why(error));
                           append(inbox_, ByteView(chunk_).first(size));
                           read_on(line);
                         }));
  }
  void write_on() { kept_ ? write_on(end_) : write_on(stream_); }
  template <class Line>
  void write_on(Line& line) {
    writing_ = true;
    under_way_.swap(outbox_);
    outbox_.clear();
    asio::async_write(line, asio::buffer(under_way_),
                      current([this, &line](const error_code& error, std::size_t) {
                        if (error) return fail(why(error));
                        writing_ = false;
                        if (!outbox_.empty()) write_on(line);
                      }));
  }
  /// The keeper ends when the robot's end does; then that is what has happened.
  [[nodiscard]] std::string why(const error_code& error) const {
    return kept_ ? "the robot's line was closed" : error.message();
  }

  bool kept_;
  std::optional<KeptLine> keeper_;
  asio::local::stream_protocol::socket end_;  ///< ours of the keeper's line
  bool open_ = false;
  bool writing_ = false;
  std::uint64_t generation_ = 0;
  std::string trouble_;
  std::array<std::uint8_t, 16384> chunk_{};
  Bytes inbox_;
  Bytes outbox_;
  Bytes under_way_;
};

class TcpLine final : public StreamLine<Tcp::socket> {
 public:
  TcpLine(TransportUrl url, bool kept)
      : StreamLine(std::move(url), kept), resolver_(io_), patience_(io_) {}

 private:
  void begin_open() override {
    opening_ = true;
    patience_.expires_after(kConnectPatience);
    patience_.async_wait(current([this](const error_code& error) {
      if (!error && opening_) fail("nobody answers at " + url_.host);
    }));
    resolver_.async_resolve(url_.host, std::to_string(url_.port),
                            current([this](const error_code& error, auto&& places) {
                              if (error) return fail(url_.host + ": " + error.message());
                              connect(places);
                            }));
  }
  void connect(const Tcp::resolver::results_type& places) {
    asio::async_connect(
        stream_, places, current([this](const error_code& error, const auto&) {
          if (error) {
            return fail(url_.host + ":" + std::to_string(url_.port) + ": " + error.message());
          }
          error_code ignored;
          stream_.set_option(Tcp::no_delay(true), ignored);
          patience_.cancel();
          opened();
        }));
  }
  void end_open() override {
    patience_.cancel();
    resolver_.cancel();
  }
  int take_descriptor() override { return stream_.release(); }

  Tcp::resolver resolver_;
  asio::steady_timer patience_;
};

class SerialLine final : public StreamLine<asio::serial_port> {
 public:
  using StreamLine::StreamLine;

 private:
  void begin_open() override {
    using Port = asio::serial_port_base;
    try {
      stream_.open(url_.device);
      stream_.set_option(Port::baud_rate(static_cast<unsigned>(url_.baud)));
      stream_.set_option(Port::character_size(8));
      stream_.set_option(Port::parity(Port::parity::none));
      stream_.set_option(Port::stop_bits(Port::stop_bits::one));
      stream_.set_option(Port::flow_control(Port::flow_control::none));
      opened();
    } catch (const boost::system::system_error& error) {
      fail(url_.device + ": " + error.code().message());
    }
  }
  /// A serial port of Asio's cannot give its own away; a terminal keeps what was set.
  int take_descriptor() override {
    const int file = ::open(url_.device.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
    if (file < 0) throw std::system_error(errno, std::generic_category(), url_.device);
    error_code ignored;
    stream_.close(ignored);
    return file;
  }
};

}  // namespace

namespace {

std::unique_ptr<Transport> make_line(const std::string& url, bool kept) {
  TransportUrl place = parse_transport_url(url);
  if (place.kind == TransportUrl::Kind::tcp) {
    return std::make_unique<TcpLine>(std::move(place), kept);
  }
  return std::make_unique<SerialLine>(std::move(place), kept);
}

}  // namespace

std::unique_ptr<Transport> make_transport(const std::string& url) {
  return make_line(url, false);
}

std::unique_ptr<Transport> make_kept_transport(const std::string& url) {
  return make_line(url, true);
}

}  // namespace striate::pioneer
