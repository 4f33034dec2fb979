#pragma once

#include <algorithm>
#include <atomic>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/beast/core/buffers_to_string.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/websocket/stream.hpp>
#include <deque>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <vector>

namespace striate::rosbridge {

/// What a rosbridge server is to one robot: sends what the robot says to who subscribed to it, and
/// keeps what is published for the robot.
class BridgeServer {
 public:
  using tcp = boost::asio::ip::tcp;

  /// @param port 0: any free one
  explicit BridgeServer(std::uint16_t port = 0)
      : acceptor_(io_, tcp::endpoint(boost::asio::ip::address_v4::loopback(), port)) {
    accept();
    thread_ = std::thread([this] { io_.run(); });
  }
  ~BridgeServer() {
    io_.stop();
    thread_.join();
  }
  BridgeServer(const BridgeServer&) = delete;
  BridgeServer& operator=(const BridgeServer&) = delete;

  [[nodiscard]] std::uint16_t port() const { return port_; }
  [[nodiscard]] std::string url() const { return "ws://127.0.0.1:" + std::to_string(port_); }
  /// Of the robot, for all who subscribed to it.
  void publish(const std::string& topic, const nlohmann::json& message) {
    const nlohmann::json operation{{"op", "publish"}, {"topic", topic}, {"msg", message}};
    say(topic, operation.dump());
  }
  /// Any words, for all who subscribed to the topic.
  void say(const std::string& topic, const std::string& text) {
    boost::asio::post(io_, [this, topic, text] {
      for (const auto& client : clients_) {
        if (std::count(client->hears.begin(), client->hears.end(), topic) > 0) client->send(text);
      }
    });
  }
  /// What clients said, oldest first, parsed.
  [[nodiscard]] std::vector<nlohmann::json> heard() const {
    const std::lock_guard lock(mutex_);
    return heard_;
  }
  /// Forward speeds that were published on cmd_vel, oldest first.
  [[nodiscard]] std::vector<double> speeds_m_s() const {
    std::vector<double> speeds;
    for (const nlohmann::json& one : heard()) {
      if (one.at("op") == "publish") speeds.push_back(one.at("msg").at("linear").at("x"));
    }
    return speeds;
  }
  /// Does nothing for so long, as a machine that is busy or suspended.
  void stall(std::chrono::milliseconds time) {
    boost::asio::post(io_, [time] { std::this_thread::sleep_for(time); });
  }
  void forget() {
    const std::lock_guard lock(mutex_);
    heard_.clear();
  }

 private:
  struct Client : std::enable_shared_from_this<Client> {
    Client(tcp::socket socket, BridgeServer& server) : stream(std::move(socket)), all(server) {}
    void begin() {
      stream.async_accept([self = shared_from_this()](auto error) {
        if (!error) self->read();
      });
    }
    void read() {
      stream.async_read(buffer, [self = shared_from_this()](auto error, std::size_t) {
        if (error) return;
        self->take(boost::beast::buffers_to_string(self->buffer.data()));
        self->buffer.clear();
        self->read();
      });
    }
    void take(const std::string& text) {
      const nlohmann::json operation = nlohmann::json::parse(text);
      if (operation.at("op") == "subscribe") hears.push_back(operation.at("topic"));
      const std::lock_guard lock(all.mutex_);
      all.heard_.push_back(operation);
    }
    void send(const std::string& text) {
      waiting.push_back(text);
      if (waiting.size() == 1) write();
    }
    void write() {
      stream.async_write(boost::asio::buffer(waiting.front()),
                         [self = shared_from_this()](auto error, std::size_t) {
                           if (error) return;
                           self->waiting.pop_front();
                           if (!self->waiting.empty()) self->write();
                         });
    }
    boost::beast::websocket::stream<boost::beast::tcp_stream> stream;
    BridgeServer& all;
    boost::beast::flat_buffer buffer;
    std::vector<std::string> hears;
    std::deque<std::string> waiting;
  };

  void accept() {
    port_ = acceptor_.local_endpoint().port();
    acceptor_.async_accept([this](auto error, tcp::socket socket) {
      if (error) return;
      clients_.push_back(std::make_shared<Client>(std::move(socket), *this));
      clients_.back()->begin();
      accept();
    });
  }

  boost::asio::io_context io_{1};
  tcp::acceptor acceptor_;
  std::atomic<std::uint16_t> port_{0};
  std::vector<std::shared_ptr<Client>> clients_;
  mutable std::mutex mutex_;  ///< guards what was heard
  std::vector<nlohmann::json> heard_;
  std::thread thread_;
};

}  // namespace striate::rosbridge
