#include "striate/platform/pioneer/keeper/kept_line.hpp"

#include <fcntl.h>
#include <poll.h>
#include <pthread.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <ctime>
#include <system_error>
#include <thread>
#include <utility>

#include "striate/platform/pioneer/keeper/line_keeper.hpp"

namespace striate::pioneer {
namespace {

/// How exactly the keeper's deadlines hold
constexpr int kKeeperTick_ms = 10;
/// For the robot's side of a TCP connection to take the last bytes before it is closed
constexpr int kLastBytes_ms = 100;
/// A keeper that lets go sends for 0.3 s at most (line_keeper.cpp), and waits for the last bytes
constexpr auto kKeeperIsGone = std::chrono::milliseconds(500);
constexpr auto kLookForIt = std::chrono::milliseconds(1);  // well below a cycle

struct KeeperEnds {
  int mind;
  int word;
  int robot;
};

/// Counts while the machine sleeps, too: then the robot was left alone.
TimePoint boot_time() {
  timespec now{};
  clock_gettime(CLOCK_BOOTTIME, &now);
  return TimePoint(std::chrono::seconds(now.tv_sec) + std::chrono::nanoseconds(now.tv_nsec));
}

bool is_only_busy() {
  return errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR;
}

/// All that the program has open would stay open as long as the keeper lives.
void close_all_but(KeeperEnds ends) {
  std::array<int, 3> kept{ends.mind, ends.word, ends.robot};
  std::sort(kept.begin(), kept.end());
  unsigned from = 0;
  for (const int file : kept) {
    if (static_cast<unsigned>(file) > from) {
      close_range(from, static_cast<unsigned>(file) - 1, 0);
    }
    from = static_cast<unsigned>(file) + 1;
  }
  close_range(from, ~0U, 0);
}

/// What the keeper does from the fork to its end. Nothing here allocates, locks or throws.
class KeeperLoop {
 public:
  KeeperLoop(LineKeeper& keeper, KeeperEnds ends) : keeper_(keeper), ends_(ends) {}

  void run() {
    while (!keeper_.done() && robot_is_there_) {
      wait();
      now_ = boot_time();
      hear_robot();
      hear_mind();
      keeper_.tick(now_);
      speak();
      if (keeper_.mind_is_shut_out()) leave_mind();
    }
    say_last();
  }

 private:
  void wait() {
    std::array<pollfd, 2> files{};
    const bool hears = ends_.mind >= 0 && keeper_.room_for_mind() > 0;
    files[0] = {hears ? ends_.mind : -1, POLLIN, 0};
    files[1] = {ends_.robot, POLLIN, 0};
    if (!keeper_.to_robot().empty()) files[1].events |= POLLOUT;
    (void)poll(files.data(), files.size(), kKeeperTick_ms);
  }
  void hear_robot() {
    const ssize_t got = read(ends_.robot, chunk_.data(), chunk_.size());
    if (got < 0 && is_only_busy()) return;
    if (got <= 0) {
      robot_is_there_ = false;
      return;
    }
    const ByteView bytes(chunk_.data(), static_cast<std::size_t>(got));
    keeper_.from_robot(bytes, now_);
    // A mind that does not read loses what is beyond the socket's buffer: nobody waits for it.
    if (ends_.mind >= 0) {
      (void)!send(ends_.mind, bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
    }
  }
  void hear_mind() {
    const std::size_t room = std::min(keeper_.room_for_mind(), chunk_.size());
    if (ends_.mind < 0 || room == 0) return;
    const ssize_t got = recv(ends_.mind, chunk_.data(), room, MSG_DONTWAIT);
    if (got < 0 && is_only_busy()) return;
    if (got > 0) {
      keeper_.from_mind(ByteView(chunk_.data(), static_cast<std::size_t>(got)), now_);
      return;
    }
    std::uint8_t word = 0;
    if (read(ends_.word, &word, 1) == 1) {
      keeper_.mind_lets_go(now_);
    } else {
      keeper_.mind_has_died(now_);
    }
    leave_mind();
  }
  void leave_mind() {
    if (ends_.mind < 0) return;
    close(ends_.mind);
    ends_.mind = -1;
  }
  void speak() {
    const ByteView bytes = keeper_.to_robot();
    if (bytes.empty()) return;
    const ssize_t took = write(ends_.robot, bytes.data(), bytes.size());
    if (took > 0) {
      keeper_.sent(static_cast<std::size_t>(took));
    } else if (took < 0 && !is_only_busy()) {
      robot_is_there_ = false;
    }
  }
  /// A socket that is closed with unread bytes throws away what was just sent, too.
  void say_last() {
    if (shutdown(ends_.robot, SHUT_WR) != 0) return;  // a serial line sends to its end by itself
    pollfd robot{ends_.robot, POLLIN, 0};
    for (int waited_ms = 0; waited_ms < kLastBytes_ms; waited_ms += kKeeperTick_ms) {
      if (poll(&robot, 1, kKeeperTick_ms) > 0 &&
          read(ends_.robot, chunk_.data(), chunk_.size()) <= 0) {
        return;
      }
    }
  }

  LineKeeper& keeper_;
  KeeperEnds ends_;
  TimePoint now_ = boot_time();
  bool robot_is_there_ = true;
  std::array<std::uint8_t, 1024> chunk_{};
};

[[noreturn]] void keep(LineKeeper& keeper, KeeperEnds ends) {
  setsid();
  prctl(PR_SET_NAME, "line-keeper");  // `killall striate` is not meant for it
  close_all_but(ends);
  (void)!chdir("/");
  KeeperLoop(keeper, ends).run();
  _exit(0);
}

}  // namespace

KeptLine::KeptLine(int robot) {
  fcntl(robot, F_SETFL, fcntl(robot, F_GETFL) | O_NONBLOCK);
  std::array<int, 2> line{-1, -1};
  std::array<int, 2> word{-1, -1};
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, line.data()) != 0 ||
      socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0, word.data()) != 0) {
    const int error = errno;
    for (const int file : {line[0], line[1], robot}) close(file);
    throw std::system_error(error, std::generic_category(), "the keeper of the line");
  }
  // No signal reaches the child: its handlers would be the program's.
  sigset_t all;
  sigset_t before;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before);
  LineKeeper keeper;
  keeper_ = fork();
  if (keeper_ == 0) keep(keeper, {line[1], word[1], robot});
  const int error = errno;
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  for (const int file : {line[1], word[1], robot}) close(file);
  end_ = line[0];
  word_ = word[0];
  if (keeper_ > 0) return;
  close(end_);
  close(word_);
  throw std::system_error(error, std::generic_category(), "the keeper of the line");
}

KeptLine::~KeptLine() {
  if (end_ >= 0) close(end_);
  if (word_ >= 0) close(word_);
  if (keeper_ > 0) waitpid(keeper_, nullptr, WNOHANG);
}

int KeptLine::release_end() {
  return std::exchange(end_, -1);
}

void KeptLine::let_go(const std::function<void()>& close_end) {
  const std::uint8_t any = 1;
  (void)!send(word_, &any, 1, MSG_NOSIGNAL);  // the keeper may be dead
  close_end();
  if (keeper_ < 0) return;
  const auto end = std::chrono::steady_clock::now() + kKeeperIsGone;
  while (waitpid(keeper_, nullptr, WNOHANG) == 0) {
    if (std::chrono::steady_clock::now() > end) {
      kill(keeper_, SIGKILL);
      waitpid(keeper_, nullptr, 0);
      break;
    }
    std::this_thread::sleep_for(kLookForIt);
  }
  keeper_ = -1;
}

}  // namespace striate::pioneer
