#include "striate/platform/served/served_line.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/read.hpp>
#include <boost/asio/write.hpp>
#include <thread>

/// Who may use a line, and for how long. Its device answers each word, a line of text, with "ok\n".
namespace striate::served {
namespace {

using namespace std::chrono_literals;
using Tcp = boost::asio::ip::tcp;

constexpr auto kIdle = 200ms;

class WordLine {
 public:
  WordLine() : line_(io_, place(), events()), thread_([this] { run(); }) {}
  ~WordLine() {
    ends = true;
    thread_.join();
  }
  [[nodiscard]] int port() const {
    return std::stoi(line_.url().substr(line_.url().rfind(':') + 1));
  }
  std::atomic<bool> streams{false};
  std::atomic<bool> floods{false};  ///< writes more than a line holds
  std::atomic<int> clients{0};
  std::atomic<bool> ends{false};

 private:
  static ServedPlace place() {
    ServedPlace place;
    place.name = "words";
    place.idle_limit = kIdle;
    place.most_waiting = std::size_t{1} << 26U;
    return place;
  }
  ServedLine::Events events() {
    return {[this] { ++clients; },
            [this](ByteView bytes) {
              for (const std::uint8_t byte : bytes) {
                if (byte != '\n') continue;
                ++words_;
                answer_ = true;
              }
            },
            [](const std::string&) {},
            [this] {
              return Dealings{words_, streams};
            }};
  }
  void run() {
    while (!ends) {
      io_.restart();
      io_.run_for(5ms);
      if (std::exchange(answer_, false)) line_.write({'o', 'k', '\n'});
      if (floods.exchange(false)) line_.write(Bytes(std::size_t{1} << 25U));
      line_.tend();
    }
  }
  boost::asio::io_context io_{1};
  std::uint64_t words_ = 0;
  bool answer_ = false;
  ServedLine line_;
  std::thread thread_;
};

class Client {
 public:
  explicit Client(const WordLine& line) : socket_(io_) {
    socket_.connect(
        {boost::asio::ip::address_v4::loopback(), static_cast<std::uint16_t>(line.port())});
  }
  void say(const std::string& text) {
    boost::system::error_code error;
    boost::asio::write(socket_, boost::asio::buffer(text), error);
  }
  /// "ok\n"; empty: the other end has closed, or nothing came.
  std::string hear(std::chrono::milliseconds patience) {
    std::string heard(3, ' ');
    boost::system::error_code failed = boost::asio::error::timed_out;
    boost::asio::async_read(socket_, boost::asio::buffer(heard),
                            [&](const auto& error, std::size_t) { failed = error; });
    io_.restart();
    io_.run_for(patience);
    if (failed == boost::asio::error::timed_out) {
      socket_.cancel();
      io_.run_for(1s);
      return "nothing";
    }
    return failed ? "closed" : heard;
  }
  void leave() { socket_.close(); }

 private:
  boost::asio::io_context io_;
  Tcp::socket socket_;
};

TEST(ServedLine, LetsAClientGoThatNeverSaysAWord) {
  const WordLine line;
  Client silent(line);
  EXPECT_EQ(silent.hear(3s), "closed");
  Client one_byte(line);
  one_byte.say("x");
  EXPECT_EQ(one_byte.hear(3s), "closed");
}

TEST(ServedLine, KeepsAClientThatSpokeUntilSomebodyWaits) {
  const WordLine line;
  Client first(line);
  first.say("word\n");
  EXPECT_EQ(first.hear(3s), "ok\n");
  EXPECT_EQ(first.hear(3 * kIdle), "nothing") << "and is not let go";
  Client second(line);
  second.say("word\n");
  EXPECT_EQ(second.hear(3s), "ok\n");
  EXPECT_EQ(first.hear(3s), "closed");
}

TEST(ServedLine, KeepsAClientToWhomItStreamsOrWhoSpeaks) {
  WordLine line;
  line.streams = true;
  Client first(line);
  Client second(line);
  EXPECT_EQ(first.hear(2 * kIdle), "nothing");
  line.streams = false;
  for (int i = 0; i < 8; ++i) {
    first.say("word\n");
    ASSERT_EQ(first.hear(3s), "ok\n");
    std::this_thread::sleep_for(kIdle / 3);
  }
  second.say("word\n");
  EXPECT_EQ(second.hear(3s), "closed") << "it has waited too long";
  EXPECT_EQ(line.clients, 1);
}

TEST(ServedLine, LetsAClientGoThatDoesNotRead) {
  WordLine line;
  line.streams = true;
  Client first(line);
  first.say("word\n");
  ASSERT_EQ(first.hear(3s), "ok\n");
  line.floods = true;
  while (line.floods) std::this_thread::sleep_for(1ms);
  Client second(line);
  second.say("word\n");
  EXPECT_EQ(second.hear(3s), "ok\n");
}

TEST(ServedLine, ServesWhoWaitsWhenTheFirstLeavesAndNobodyWhoHasHungUp) {
  const WordLine line;
  Client first(line);
  first.say("word\n");
  EXPECT_EQ(first.hear(3s), "ok\n");
  {
    Client gone(line);
    gone.say("word\n");
    std::this_thread::sleep_for(50ms);
  }
  Client second(line);
  second.say("word\n");
  std::this_thread::sleep_for(50ms);
  Client third(line);
  EXPECT_EQ(third.hear(3s), "closed") << "one may wait";
  first.leave();
  EXPECT_EQ(second.hear(3s), "ok\n");
  EXPECT_EQ(line.clients, 2) << "not the one that had gone";
}

}  // namespace
}  // namespace striate::served
