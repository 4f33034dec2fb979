#include "striate/platform/ros/master_watch.hpp"

#include <netdb.h>
#include <poll.h>
#include <ros/master.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

#include "striate/base/steady_clock.hpp"

namespace striate::ros {
namespace {

/// A master that is gone is noticed within kMasterSilent (ros_robot.cpp)
constexpr auto kAskEvery = std::chrono::milliseconds(250);
/// A master in the same building answers well within it (ours)
constexpr int kAnswerWithin_ms = 300;

/// Where the master listens; looked up once, for a name server may take long.
struct Address {
  sockaddr_storage bytes{};
  socklen_t size = 0;
};

Address address_of(const std::string& host, std::uint32_t port) {
  Address address;
  addrinfo hints{};
  hints.ai_socktype = SOCK_STREAM;
  addrinfo* found = nullptr;
  if (getaddrinfo(host.c_str(), std::to_string(port).c_str(), &hints, &found) != 0) return address;
  // roscpp joined it by IPv4; a name may have both.
  for (const addrinfo* one = found; one != nullptr; one = one->ai_next) {
    if (address.size != 0 && one->ai_family != AF_INET) continue;
    address.size = one->ai_addrlen;
    std::copy_n(reinterpret_cast<const char*>(one->ai_addr), one->ai_addrlen,
                reinterpret_cast<char*>(&address.bytes));
    if (one->ai_family == AF_INET) break;
  }
  freeaddrinfo(found);
  return address;
}

class Socket {
 public:
  explicit Socket(int family)
      : file_(socket(family, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0)) {}
  ~Socket() {
    if (file_ >= 0) close(file_);
  }
  Socket(const Socket&) = delete;
  Socket& operator=(const Socket&) = delete;
  [[nodiscard]] int file() const { return file_; }
  [[nodiscard]] bool ready(short what) const {
    pollfd one{file_, what, 0};
    return poll(&one, 1, kAnswerWithin_ms) == 1 && (one.revents & what) != 0;
  }

 private:
  int file_;
};

/// XML-RPC's getPid, of which any answer is enough.
std::string question() {
  const std::string body =
      "<?xml version=\"1.0\"?><methodCall><methodName>getPid</methodName><params><param>"
      "<value><string>/striate</string></value></param></params></methodCall>";
  return "POST / HTTP/1.0\r\nContent-Type: text/xml\r\nContent-Length: " +
         std::to_string(body.size()) + "\r\n\r\n" + body;
}

bool answers(const Address& address) {
  const Socket link(address.bytes.ss_family);
  const auto* to = reinterpret_cast<const sockaddr*>(&address.bytes);
  if (connect(link.file(), to, address.size) != 0 && errno != EINPROGRESS) return false;
  if (!link.ready(POLLOUT)) return false;
  const std::string text = question();
  const ssize_t sent = send(link.file(), text.data(), text.size(), MSG_NOSIGNAL);
  if (sent != static_cast<ssize_t>(text.size()) || !link.ready(POLLIN)) return false;
  char answer[16] = {};
  return recv(link.file(), answer, sizeof(answer) - 1, 0) > 0 &&
         std::string(answer).rfind("HTTP/1.", 0) == 0;
}

/// Whatever goes wrong in asking is no answer; nothing may end the thread, and the program.
bool hears(const Address& address) noexcept {
  try {
    return answers(address);
  } catch (...) {
    return false;
  }
}

}  // namespace

struct MasterWatch::Parts {
  void ask_again_and_again() {
    const Address address = address_of(::ros::master::getHost(), ::ros::master::getPort());
    std::unique_lock lock(mutex);
    while (!ends) {
      lock.unlock();
      if (hears(address)) heard = clock.now();
      lock.lock();
      wake.wait_for(lock, kAskEvery, [this] { return ends; });
    }
  }

  SteadyClock clock;
  std::atomic<TimePoint> heard{TimePoint{}};
  std::mutex mutex;
  std::condition_variable wake;
  bool ends = false;
  std::thread thread;
};

MasterWatch::MasterWatch() : parts_(std::make_unique<Parts>()) {
  parts_->heard = parts_->clock.now();
  parts_->thread = std::thread([parts = parts_.get()] { parts->ask_again_and_again(); });
}

MasterWatch::~MasterWatch() {
  {
    const std::lock_guard lock(parts_->mutex);
    parts_->ends = true;
  }
  parts_->wake.notify_all();
  parts_->thread.join();
}

Duration MasterWatch::silent_for() const {
  return parts_->clock.now() - parts_->heard.load();
}

}  // namespace striate::ros
