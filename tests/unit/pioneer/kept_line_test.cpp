#include "striate/platform/pioneer/keeper/kept_line.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>

#include "striate/platform/pioneer/arcos/command.hpp"
#include "striate/platform/pioneer/transport.hpp"

namespace striate::pioneer {
namespace {

using arcos::Command;
using arcos::command;

/// A socket pair: the line and the robot's end of it.
struct Wire {
  Wire() { EXPECT_EQ(socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()), 0); }
  ~Wire() { close(ends[1]); }
  /// What the robot gets until nothing has come for 300 ms, or the line is closed.
  Bytes heard(int patience_ms = 300) {
    Bytes bytes;
    pollfd robot{ends[1], POLLIN, 0};
    while (poll(&robot, 1, patience_ms) > 0) {
      std::array<std::uint8_t, 256> chunk{};
      const ssize_t got = read(ends[1], chunk.data(), chunk.size());
      if (got <= 0) {
        closed = true;
        break;
      }
      append(bytes, ByteView(chunk).first(static_cast<std::size_t>(got)));
      if (bytes.size() > 4000) break;
    }
    return bytes;
  }
  std::array<int, 2> ends{-1, -1};
  bool closed = false;
};

void write_all(int file, const Bytes& bytes) {
  EXPECT_EQ(write(file, bytes.data(), bytes.size()), static_cast<ssize_t>(bytes.size()));
}

TEST(KeptLine, PassesOnBothWaysAndIsFreeWhenItIsLetGo) {
  Wire wire;
  KeptLine line(wire.ends[0]);
  const int end = line.release_end();
  write_all(end, command(Command::open, 1));
  EXPECT_EQ(wire.heard(), command(Command::open, 1));
  write_all(wire.ends[1], Bytes{1, 2, 3});
  std::array<std::uint8_t, 8> chunk{};
  pollfd mind{end, POLLIN, 0};
  ASSERT_EQ(poll(&mind, 1, 2000), 1);
  EXPECT_EQ(read(end, chunk.data(), chunk.size()), 3);
  write_all(end, command(Command::pulse));
  line.let_go([end] { close(end); });
  EXPECT_EQ(wire.heard(), command(Command::pulse)) << "no stop, no CLOSE";
  EXPECT_TRUE(wire.closed);
}

TEST(KeptLine, OutlivesAMindThatIsKilledAndStopsItsRobot) {
  for (const int signal : {SIGKILL, SIGSEGV}) {
    Wire wire;
    const pid_t mind = fork();
    if (mind == 0) {
      std::signal(SIGSEGV, SIG_DFL);
      KeptLine line(wire.ends[0]);
      write_all(line.release_end(), command(Command::open, 1));
      kill(getpid(), signal);
      pause();
    }
    close(wire.ends[0]);
    waitpid(mind, nullptr, 0);
    Bytes stop = command(Command::open, 1);
    append(stop, command(Command::velocity, 0));
    append(stop, command(Command::rotation_velocity, 0));
    const Bytes heard = wire.heard();
    ASSERT_GE(heard.size(), stop.size());
    EXPECT_TRUE(std::equal(stop.begin(), stop.end(), heard.begin()));
  }
}

TEST(KeptLine, OfAKeeperThatIsKilledTheMindLearnsAtOnce) {
  Wire wire;
  KeptLine line(wire.ends[0]);
  const int end = line.release_end();
  kill(line.keeper(), SIGKILL);
  pollfd mind{end, POLLIN, 0};
  EXPECT_EQ(poll(&mind, 1, 2000), 1);
  char byte = 0;
  EXPECT_EQ(read(end, &byte, 1), 0);
  line.let_go([end] { close(end); });  // a signal for a word that nobody hears would end the mind
}

TEST(KeptLine, TheKeeperHoldsNothingElseOpenAndTheTerminalsSignalsDoNotReachIt) {
  std::array<int, 2> other{};
  ASSERT_EQ(pipe(other.data()), 0);
  Wire wire;
  KeptLine line(wire.ends[0]);
  const int end = line.release_end();
  close(other[1]);
  char byte = 0;
  pollfd reader{other[0], POLLIN, 0};
  ASSERT_EQ(poll(&reader, 1, 2000), 1) << "the keeper holds the writing end";
  EXPECT_EQ(read(other[0], &byte, 1), 0);
  close(other[0]);
  EXPECT_NE(getpgid(line.keeper()), getpgid(0));
  for (const int signal : {SIGHUP, SIGINT, SIGQUIT, SIGPIPE, SIGTERM, SIGTSTP}) {
    kill(line.keeper(), signal);
  }
  write_all(end, command(Command::pulse));
  EXPECT_EQ(wire.heard(), command(Command::pulse));
  line.let_go([end] { close(end); });
}

}  // namespace
}  // namespace striate::pioneer
