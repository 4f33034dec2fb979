#include "striate/platform/rosbridge/twist_keeper.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <exception>
#include <thread>

#include "striate/platform/rosbridge/bridge_client.hpp"
#include "striate/platform/rosbridge/operations.hpp"

namespace striate::rosbridge {
namespace {

/// Two in a row of the mind's words, 50 ms each, may be late; as the keeper of a Pioneer's line
constexpr int kMindLease_ms = 250;
constexpr int kSayZeroEvery_ms = 50;  // as often as the mind publishes (rosbridge_robot.cpp)
/// A line that broke is back by then; a second is also RosAria's patience
constexpr int kLongestZeros_ms = 1000;
/// The good-bye of its line, by hand; the mind does not wait any longer
constexpr auto kKeeperEnds = std::chrono::milliseconds(700);
/// Of messages, which the keeper asks for none of: those of the status
constexpr std::size_t kMostBytes = std::size_t{1} << 20U;

enum class Word : char { stands = 's', moves = 'm', ends = 'e' };

/// The last of the mind's words. @return false at its end
bool read_last_word(int line, Word& word) {
  std::array<char, 64> words{};
  const ssize_t got = read(line, words.data(), words.size());
  if (got <= 0) return false;
  word = static_cast<Word>(words.at(static_cast<std::size_t>(got) - 1));
  return true;
}

BridgeClient::Hears advertises_only(const BridgeSettings& settings) {
  return {.greetings = [settings] { return std::vector{greetings(settings, false).front()}; },
          .message = [](std::string_view) {},
          .broke = [] {},
          .tick = [] {}};
}

void keep_twists(int line, const BridgeSettings& settings) {
  BridgeClient client(read_bridge_address(settings.url), kMostBytes, advertises_only(settings));
  const std::string zero = publish_twist(settings, {}, std::nullopt);
  Word word = Word::stands;
  bool heard = true;
  bool silent = false;
  while (heard && word != Word::ends) {
    pollfd mind{line, POLLIN, 0};
    if (poll(&mind, 1, silent ? kSayZeroEvery_ms : kMindLease_ms) > 0) {
      heard = read_last_word(line, word);
      silent = false;
    } else if (word == Word::moves) {
      silent = true;
      client.say_newest(zero);
    }
  }
  // It has died, whatever it said last: a robot that was told to stand may still obey another.
  for (int said_ms = 0; !heard && said_ms < kLongestZeros_ms; said_ms += kSayZeroEvery_ms) {
    client.say_newest(zero);
    std::this_thread::sleep_for(std::chrono::milliseconds(kSayZeroEvery_ms));
  }
  client.end(heard ? std::vector<std::string>{} : std::vector{zero});
}

[[noreturn]] void be_the_twist_keeper(int line, const BridgeSettings& settings) {
  setsid();
  prctl(PR_SET_NAME, "twist-keeper");
  // What the program has open would stay so; and nobody is to wait for this one's output.
  const int nothing = open("/dev/null", O_RDWR);
  for (int stream = 0; stream < 3; ++stream) dup2(nothing, stream);
  close_range(3, static_cast<unsigned>(line) - 1, 0);
  close_range(static_cast<unsigned>(line) + 1, ~0U, 0);
  try {
    keep_twists(line, settings);
  } catch (const std::exception&) {  // no such host: the program says so itself
  }
  _exit(0);
}

}  // namespace

TwistKeeper::TwistKeeper(const BridgeSettings& settings) {
  std::array<int, 2> line{-1, -1};
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, line.data()) != 0) return;
  // The terminal's signals are not meant for it.
  sigset_t all;
  sigset_t before;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before);
  keeper_ = fork();
  if (keeper_ == 0) be_the_twist_keeper(line[1], settings);
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  close(line[1]);
  line_ = line[0];
}

TwistKeeper::~TwistKeeper() {
  if (line_ < 0) return;
  const char end = static_cast<char>(Word::ends);
  (void)!send(line_, &end, 1, MSG_NOSIGNAL | MSG_DONTWAIT);
  close(line_);
  const auto latest = std::chrono::steady_clock::now() + kKeeperEnds;
  while (keeper_ > 0 && waitpid(keeper_, nullptr, WNOHANG) == 0 &&
         std::chrono::steady_clock::now() < latest) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
}

void TwistKeeper::hear(bool moves) noexcept {
  if (line_ < 0) return;
  const char word = static_cast<char>(moves ? Word::moves : Word::stands);
  (void)!send(line_, &word, 1, MSG_NOSIGNAL | MSG_DONTWAIT);
}

}  // namespace striate::rosbridge
