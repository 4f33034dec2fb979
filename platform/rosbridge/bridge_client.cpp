#include "striate/platform/rosbridge/bridge_client.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <boost/asio/io_context.hpp>
#include <boost/asio/post.hpp>
#include <mutex>
#include <stdexcept>
#include <thread>
#include <utility>

#include "striate/base/steady_clock.hpp"
#include "striate/platform/rosbridge/bridge_line.hpp"

namespace striate::rosbridge {
namespace {

namespace asio = boost::asio;

constexpr auto kTickEvery = std::chrono::milliseconds(50);  // twice a cycle, as RosRobot publishes
constexpr int kTicksAPing = 2;  ///< ten questions a second: a fifth of the shortest deadline
/// Pauses before a line is tried again, by hand: the second try finds a server that restarts
constexpr auto kFirstPause = std::chrono::milliseconds(250);
constexpr auto kLongestPause = std::chrono::seconds(2);
/// The last words and the other side's good-bye, by hand: ten round trips of a bad wireless line
constexpr auto kEndTakes = std::chrono::milliseconds(500);

}  // namespace

struct BridgeClient::Parts {
  Parts(BridgeAddress to, std::size_t most_bytes, Hears what)
      : address(std::move(to)), most_message_bytes(most_bytes), hears(std::move(what)) {
    boost::system::error_code error;
    asio::ip::tcp::resolver resolver(io);
    endpoints = resolver.resolve(address.host, std::to_string(address.port), error);
    if (error) {
      throw std::runtime_error(fmt::format("rosbridge.url {}: the host '{}' is not known: {}",
                                           address.url, address.host, error.message()));
    }
  }
  void run();
  void connect();
  void tick();
  void line_gone(const std::string& why);
  void note(const std::string& why) {
    const std::lock_guard lock(mutex);
    trouble = why;
  }

  BridgeAddress address;
  std::size_t most_message_bytes;
  Hears hears;
  SteadyClock clock;
  std::atomic<bool> open{false};
  std::atomic<std::int64_t> answered_ns{0};
  mutable std::mutex mutex;  ///< guards `trouble`
  std::string trouble;

  // The thread's own, once it runs.
  asio::io_context io{1};
  BridgeLine::Endpoints endpoints;
  std::shared_ptr<BridgeLine> line;
  asio::steady_timer ticks{io};
  asio::steady_timer again{io};
  asio::steady_timer last_moment{io};
  std::chrono::milliseconds pause = kFirstPause;
  int ticked = 0;
  bool ending = false;

  std::thread thread;
};

void BridgeClient::Parts::run() {
  connect();
  tick();
  while (true) {
    try {
      io.run();
      return;
    } catch (...) {  // of one handler, which is done with
    }
  }
}

void BridgeClient::Parts::connect() {
  BridgeLine::Hears what;
  what.opened = [this] {
    pause = kFirstPause;
    answered_ns = clock.now().time_since_epoch().count();
    for (std::string& greeting : hears.greetings()) line->say(std::move(greeting));
    open = true;
  };
  what.message = [this](std::string_view message) { hears.message(message); };
  what.answered = [this] { answered_ns = clock.now().time_since_epoch().count(); };
  what.gone = [this](const std::string& why) { line_gone(why); };
  line = std::make_shared<BridgeLine>(io, address, most_message_bytes, std::move(what));
  line->connect(endpoints);
}

void BridgeClient::Parts::line_gone(const std::string& why) {
  if (ending) return io.stop();
  const bool was_open = open.exchange(false);
  note(why);
  if (was_open) hears.broke();
  again.expires_after(pause);
  pause = std::min<std::chrono::milliseconds>(2 * pause, kLongestPause);
  again.async_wait([this](const auto& error) {
    if (!error && !ending) connect();
  });
}

void BridgeClient::Parts::tick() {
  ticks.expires_after(kTickEvery);
  ticks.async_wait([this](const auto& error) {
    if (error || ending) return;
    tick();
    if (ticked++ % kTicksAPing == 0) line->ping();
    hears.tick();
  });
}

BridgeClient::BridgeClient(const BridgeAddress& address, std::size_t most_message_bytes,
                           Hears hears)
    : parts_(std::make_unique<Parts>(address, most_message_bytes, std::move(hears))) {
  parts_->thread = std::thread([parts = parts_.get()] { parts->run(); });
}

BridgeClient::~BridgeClient() {
  if (!parts_->thread.joinable()) return;
  parts_->io.stop();
  parts_->thread.join();
}

void BridgeClient::say(std::string message) {
  asio::post(parts_->io, [parts = parts_.get(), message = std::move(message)]() mutable {
    parts->line->say(std::move(message));
  });
}

void BridgeClient::say_newest(std::string message) {
  asio::post(parts_->io, [parts = parts_.get(), message = std::move(message)]() mutable {
    parts->line->say_newest(std::move(message));
  });
}

void BridgeClient::end(std::vector<std::string> last_words) noexcept {
  if (!parts_->thread.joinable()) return;
  try {
    asio::post(parts_->io, [parts = parts_.get(), last_words = std::move(last_words)]() mutable {
      parts->ending = true;
      parts->ticks.cancel();
      parts->again.cancel();
      parts->last_moment.expires_after(kEndTakes);
      parts->last_moment.async_wait([parts](const auto&) { parts->io.stop(); });
      if (!parts->line->is_open()) return parts->io.stop();
      parts->line->say_good_bye(std::move(last_words));
    });
  } catch (...) {  // no memory for a good-bye: the line just ends
    parts_->io.stop();
  }
  parts_->thread.join();
  parts_->open = false;
}

bool BridgeClient::is_open() const {
  return parts_->open;
}

Duration BridgeClient::silent_for() const {
  return parts_->clock.now().time_since_epoch() - Duration(parts_->answered_ns.load());
}

std::string BridgeClient::trouble() const {
  const std::lock_guard lock(parts_->mutex);
  return parts_->trouble;
}

}  // namespace striate::rosbridge
