#include "striate/platform/remote/zero_keeper.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <exception>
#include <thread>

namespace striate::remote {
namespace {

/// Two in a row of the mind's words, 50 ms each, may be late; as the keeper of a Pioneer's line
constexpr int kMindLease_ms = 250;
constexpr int kZeroEvery_ms = 50;  // as often as a mind publishes (ros_robot, rosbridge_robot)
/// Lines that broke are back by then; a second is also RosAria's patience
constexpr int kLongestZeros_ms = 1000;

enum class Word : char { stands = 's', moves = 'm', ends = 'e' };

/// The last of the mind's words. @return false at its end
bool read_last_word(int line, Word& word) {
  std::array<char, 64> words{};
  const ssize_t got = read(line, words.data(), words.size());
  if (got <= 0) return false;
  word = static_cast<Word>(words.at(static_cast<std::size_t>(got) - 1));
  return true;
}

void keep(int line, const KeeperVoice& voice) {
  Word word = Word::stands;
  bool heard = true;
  bool silent = false;
  while (heard && word != Word::ends) {
    pollfd mind{line, POLLIN, 0};
    if (poll(&mind, 1, silent ? kZeroEvery_ms : kMindLease_ms) > 0) {
      heard = read_last_word(line, word);
      silent = false;
    } else if (word == Word::moves) {
      silent = true;
      voice.say_zero();
    }
  }
  // It has died, whatever it said last: a robot that was told to stand may still obey another.
  for (int said_ms = 0; !heard && said_ms < kLongestZeros_ms; said_ms += kZeroEvery_ms) {
    voice.say_zero();
    std::this_thread::sleep_for(std::chrono::milliseconds(kZeroEvery_ms));
  }
  if (voice.end) voice.end(!heard);
}

[[noreturn]] void be_the_zero_keeper(int line, const char* name,
                                     const std::function<KeeperVoice()>& make_voice) {
  setsid();
  prctl(PR_SET_NAME, name);
  // What the program has open would stay so; and nobody is to wait for this one's output.
  const int nothing = open("/dev/null", O_RDWR);
  for (int stream = 0; stream < 3; ++stream) dup2(nothing, stream);
  close_range(3, static_cast<unsigned>(line) - 1, 0);
  close_range(static_cast<unsigned>(line) + 1, ~0U, 0);
  try {
    keep(line, make_voice());
  } catch (const std::exception&) {  // nobody to speak to: the program says so itself
  }
  _exit(0);
}

}  // namespace

ZeroKeeper::ZeroKeeper(const char* name, const std::function<KeeperVoice()>& make_voice,
                       std::chrono::milliseconds ends_within)
    : ends_within_(ends_within) {
  std::array<int, 2> line{-1, -1};
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, line.data()) != 0) return;
  // The terminal's signals are not meant for it.
  sigset_t all;
  sigset_t before;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before);
  keeper_ = fork();
  if (keeper_ == 0) be_the_zero_keeper(line[1], name, make_voice);
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  close(line[1]);
  line_ = line[0];
}

ZeroKeeper::~ZeroKeeper() {
  if (line_ < 0) return;
  const char end = static_cast<char>(Word::ends);
  (void)!send(line_, &end, 1, MSG_NOSIGNAL | MSG_DONTWAIT);
  close(line_);
  const auto latest = std::chrono::steady_clock::now() + ends_within_;
  while (keeper_ > 0 && waitpid(keeper_, nullptr, WNOHANG) == 0 &&
         std::chrono::steady_clock::now() < latest) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
}

void ZeroKeeper::hear(bool moves) noexcept {
  if (line_ < 0) return;
  const char word = static_cast<char>(moves ? Word::moves : Word::stands);
  (void)!send(line_, &word, 1, MSG_NOSIGNAL | MSG_DONTWAIT);
}

}  // namespace striate::remote
