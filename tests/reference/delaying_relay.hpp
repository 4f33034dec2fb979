#pragma once

#include <arpa/inet.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <chrono>
#include <deque>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace striate::reference {

/// A TCP relay on the loopback that takes its time: each way has a delay that may be set at any
/// moment and counts for what comes in from then on, and may be held, so that all that came in
/// meanwhile is let go at once. Bytes keep their order; nothing is lost.
class DelayingRelay {
 public:
  /// @param url of the server, "tcp://127.0.0.1:8101"
  explicit DelayingRelay(const std::string& url) : server_(address_of(url)) {
    listener_ = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_in any = address_of("tcp://127.0.0.1:0");
    socklen_t size = sizeof(any);
    if (bind(listener_, reinterpret_cast<sockaddr*>(&any), size) != 0 || listen(listener_, 4) != 0)
      throw std::runtime_error("the relay finds no port");
    getsockname(listener_, reinterpret_cast<sockaddr*>(&any), &size);
    url_ = "tcp://127.0.0.1:" + std::to_string(ntohs(any.sin_port));
    thread_ = std::thread([this] { run(); });
  }
  ~DelayingRelay() {
    ends_ = true;
    thread_.join();
    close(listener_);
  }
  DelayingRelay(const DelayingRelay&) = delete;
  DelayingRelay& operator=(const DelayingRelay&) = delete;

  [[nodiscard]] const std::string& url() const { return url_; }
  void delay_to_server(double seconds) { ways_[0].delay_s = seconds; }
  void delay_from_server(double seconds) { ways_[1].delay_s = seconds; }
  void hold_to_server(bool on) { ways_[0].held = on; }
  void hold_from_server(bool on) { ways_[1].held = on; }

 private:
  using Steady = std::chrono::steady_clock;
  struct Chunk {
    Steady::time_point due;
    std::vector<char> bytes;
    std::size_t sent = 0;
  };
  struct Way {
    std::atomic<double> delay_s{0.0};
    std::atomic<bool> held{false};
    std::deque<Chunk> under_way;  // of the relay's thread alone
  };

  static sockaddr_in address_of(const std::string& url) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(std::stoi(url.substr(url.rfind(':') + 1))));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    return address;
  }
  void run() {
    while (!ends_) {
      pollfd waiting{listener_, POLLIN, 0};
      if (poll(&waiting, 1, 20) != 1) continue;
      const int client = accept4(listener_, nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC);
      const int server = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
      if (connect(server, reinterpret_cast<const sockaddr*>(&server_), sizeof(server_)) == 0) {
        serve(client, server);
      }
      close(client);
      close(server);
      for (Way& way : ways_) way.under_way.clear();
    }
  }
  void serve(int client, int server) {
    const int on = 1;
    for (const int end : {client, server}) {
      setsockopt(end, IPPROTO_TCP, TCP_NODELAY, &on, sizeof(on));
    }
    while (!ends_) {
      std::array<pollfd, 2> ends{pollfd{client, POLLIN, 0}, pollfd{server, POLLIN, 0}};
      poll(ends.data(), ends.size(), 2);
      if (!take(ends[0], ways_[0]) || !take(ends[1], ways_[1])) return;
      if (!give(server, ways_[0]) || !give(client, ways_[1])) return;
    }
  }
  /// False: that end is closed.
  static bool take(const pollfd& from, Way& way) {
    if ((from.revents & (POLLIN | POLLHUP | POLLERR)) == 0) return true;
    std::array<char, 65536> bytes{};
    const ssize_t size = recv(from.fd, bytes.data(), bytes.size(), MSG_DONTWAIT);
    if (size <= 0) return size < 0 && (errno == EAGAIN || errno == EINTR);
    const auto delay = std::chrono::duration_cast<Steady::duration>(
        std::chrono::duration<double>(way.delay_s.load()));
    Steady::time_point due = Steady::now() + delay;
    if (!way.under_way.empty()) due = std::max(due, way.under_way.back().due);  // keeps the order
    way.under_way.push_back({due, {bytes.begin(), bytes.begin() + size}});
    return true;
  }
  static bool give(int to, Way& way) {
    while (!way.held && !way.under_way.empty() && way.under_way.front().due <= Steady::now()) {
      Chunk& chunk = way.under_way.front();
      const ssize_t size = send(to, chunk.bytes.data() + chunk.sent,
                                chunk.bytes.size() - chunk.sent, MSG_DONTWAIT | MSG_NOSIGNAL);
      if (size < 0) return errno == EAGAIN || errno == EINTR;
      chunk.sent += static_cast<std::size_t>(size);
      if (chunk.sent < chunk.bytes.size()) return true;
      way.under_way.pop_front();
    }
    return true;
  }

  sockaddr_in server_;
  int listener_ = -1;
  std::string url_;
  std::array<Way, 2> ways_;
  std::atomic<bool> ends_{false};
  std::thread thread_;  // last: it uses all of the above
};

}  // namespace striate::reference
