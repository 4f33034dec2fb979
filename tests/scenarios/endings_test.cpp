#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <pty.h>
#include <sys/resource.h>

#include <array>
#include <atomic>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <thread>

#include "striate/platform/pioneer/session_settings.hpp"
#include "tests/scenarios/exit_code_within.hpp"
#include "tests/scenarios/served_hall.hpp"
#include "tests/scenarios/striate_process.hpp"

/// What becomes of the robot, and of what was to be written, when the program ends otherwise than
/// it was meant to. Looked at by the robot's true motion, at full speed.
namespace striate::scenarios {
namespace {

using namespace std::chrono_literals;
using served::ServedState;

constexpr double kFull_m_s = 0.65;
/// 0.3 s are promised. A loaded machine adds to what the test itself sees, most where the mind ends
/// its own cycle first.
constexpr double kKeeperStopsWithin_s = 0.45;
constexpr double kMindStopsWithin_s = 0.7;
/// Beyond the braking distance: 0.2 m are promised
constexpr double kKeeperStopsAfter_m = 0.2;
constexpr double kMindStopsAfter_m = 0.4;

[[noreturn]] void become_drive(const std::string& url) {
  const rlimit no_core{0, 0};
  setrlimit(RLIMIT_CORE, &no_core);
  execl(STRIATE_BINARY, STRIATE_BINARY, "drive", url.c_str(), "--forward-m-s", "0.65", "--for-s",
        "60", nullptr);
  _exit(98);
}

pid_t start_drive(const std::string& url) {
  const pid_t child = fork();
  if (child != 0) return child;
  if (freopen("/dev/null", "w", stdout) == nullptr) _exit(99);
  become_drive(url);
}

struct Stop {
  double commanded_s = 0.0;
  double stood_s = 0.0;
  double way_m = 0.0;
};

/// What the robot does from now on, until it stands.
Stop stop_of(const Served& served) {
  const ServedState begin = served.state();
  Stop stop;
  stop.commanded_s = served.until([](auto& s) { return s.commanded_to_stand; }, 6.0);
  served.until([](auto& s) { return s.true_forward_m_s == 0.0; }, 6.0);
  const ServedState end = served.state();
  stop.stood_s = end.time_s - begin.time_s;
  stop.way_m =
      std::hypot(end.true_pose.x_m - begin.true_pose.x_m, end.true_pose.y_m - begin.true_pose.y_m);
  return stop;
}

void expect_a_short_stop(const std::string& ending, const Stop& stop, bool by_keeper) {
  const auto record = [&](const char* what, double value) {
    testing::Test::RecordProperty(ending + what, std::to_string(value));
  };
  record("_commanded_s", stop.commanded_s);
  record("_stood_s", stop.stood_s);
  record("_way_m", stop.way_m);
  const double braking_m =
      kFull_m_s * kFull_m_s / (2.0 * pioneer::SessionSettings{}.acceleration_m_s2);
  EXPECT_LT(stop.commanded_s, by_keeper ? kKeeperStopsWithin_s : kMindStopsWithin_s);
  EXPECT_LT(stop.way_m, braking_m + (by_keeper ? kKeeperStopsAfter_m : kMindStopsAfter_m));
}

void expect_a_closed_session(const Served& served) {
  EXPECT_LT(served.until([](auto& s) { return !s.connected && !s.motors_on; }, 5.0), 5.0);
  EXPECT_EQ(served.state().true_forward_m_s, 0.0);
}

void reach_full_speed(const Served& served) {
  ASSERT_LT(served.until([](auto& s) { return s.true_forward_m_s > kFull_m_s - 0.005; }, 20.0),
            20.0);
}

struct SignalEnding {
  const char* name;
  int signal;
  int exit_code;  ///< -1: it dies of it
  bool pty = false;
};

constexpr std::array kEndings{SignalEnding{"Int", SIGINT, 130},
                              SignalEnding{"Term", SIGTERM, 130},
                              SignalEnding{"Hup", SIGHUP, 130},
                              SignalEnding{"Pipe", SIGPIPE, 130},
                              SignalEnding{"Quit", SIGQUIT, 130},
                              SignalEnding{"Xfsz", SIGXFSZ, 130},
                              SignalEnding{"Usr2", SIGUSR2, 130},
                              SignalEnding{"Alrm", SIGALRM, 130},
                              SignalEnding{"Xcpu", SIGXCPU, 130},
                              SignalEnding{"Segv", SIGSEGV, -1},
                              SignalEnding{"Abrt", SIGABRT, -1},
                              SignalEnding{"Bus", SIGBUS, -1},
                              SignalEnding{"Fpe", SIGFPE, -1},
                              SignalEnding{"Ill", SIGILL, -1},
                              SignalEnding{"Sys", SIGSYS, -1},
                              SignalEnding{"Kill", SIGKILL, -1},
                              SignalEnding{"Stop", SIGSTOP, -1},
                              SignalEnding{"IntPty", SIGINT, 130, true},
                              SignalEnding{"HupPty", SIGHUP, 130, true},
                              SignalEnding{"SegvPty", SIGSEGV, -1, true},
                              SignalEnding{"KillPty", SIGKILL, -1, true},
                              SignalEnding{"StopPty", SIGSTOP, -1, true}};

void expect_the_robot_to_stand(const SignalEnding& ending) {
  SCOPED_TRACE(ending.name);
  const Served served({.pty = ending.pty});
  const pid_t child = start_drive(served.url());
  reach_full_speed(served);
  kill(child, ending.signal);
  expect_a_short_stop(ending.name, stop_of(served), ending.exit_code < 0);
  // Who is only stopped may be let go on: its session stays until it dies.
  if (ending.signal == SIGSTOP) {
    EXPECT_TRUE(served.state().connected);
    kill(child, SIGKILL);
  }
  expect_a_closed_session(served);
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_EQ(WIFEXITED(status) ? WEXITSTATUS(status) : -1, ending.exit_code);
}

/// Robots and programs of their own that mostly wait: so many at once, side by side.
constexpr std::size_t kAtOnce = 4;

TEST(SignalEnds, AndTheRobotStandsAndItsSessionIsClosed) {
  std::atomic<std::size_t> next{0};
  const auto take_some = [&] {
    for (std::size_t i = next++; i < kEndings.size(); i = next++) {
      expect_the_robot_to_stand(kEndings[i]);
    }
  };
  std::vector<std::jthread> side_by_side;
  for (std::size_t i = 0; i < kAtOnce; ++i) side_by_side.emplace_back(take_some);
}

TEST(Endings, ASecondCtrlCStillClosesAndAThirdKillsButTheRobotBrakes) {
  for (const int times : {2, 3}) {
    const Served served;
    const pid_t child = start_drive(served.url());
    reach_full_speed(served);
    for (int i = 0; i < times; ++i) {
      if (i > 0) std::this_thread::sleep_for(250ms);
      kill(child, SIGINT);
    }
    served.until([](auto& s) { return s.true_forward_m_s == 0.0; }, 6.0);
    expect_a_closed_session(served);
    int status = 0;
    waitpid(child, &status, 0);
    EXPECT_EQ(WIFEXITED(status) ? WEXITSTATUS(status) : -1, times == 2 ? 130 : -1);
  }
}

TEST(Endings, TheDeathOfTheTerminalStopsTheRobot) {
  const Served served;
  int terminal = -1;
  const pid_t child = forkpty(&terminal, nullptr, nullptr, nullptr);
  if (child == 0) become_drive(served.url());
  std::atomic<bool> reads{true};
  std::thread reader([&] {
    std::array<char, 1024> chunk{};
    while (reads && read(terminal, chunk.data(), chunk.size()) > 0) {
    }
  });
  reach_full_speed(served);
  reads = false;
  reader.join();
  close(terminal);
  expect_a_short_stop("Terminal", stop_of(served), false);
  expect_a_closed_session(served);
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_EQ(WIFEXITED(status) ? WEXITSTATUS(status) : -1, 130);
}

/// Somebody reads the first lines of the output and no more: that is no reason to stop.
TEST(Endings, AnOutputThatNobodyReadsAnyMoreEndsNoDrive) {
  for (const std::string where : {"| head -n 2 > /dev/null", "> /dev/full", ">&-"}) {
    const Served served;
    const Ended ended =
        bash("\"$striate\" drive " + served.url() + " --forward-m-s 0.4 --way-m 1.5 " + where +
             "; echo ${PIPESTATUS[0]} >&2");
    EXPECT_GT(served.state().true_pose.x_m, 1.0) << where << ended.err;
    EXPECT_THAT(ended.err, testing::HasSubstr("\n1\n")) << where;
    EXPECT_LT(served.until([](auto& s) { return !s.connected; }, 3.0), 3.0);
  }
}

/// A pipe that nobody empties must not hold up the loop: the robot would stand after its lease.
TEST(Endings, AnOutputThatNobodyTakesHoldsUpNoDrive) {
  const Served served;
  std::array<int, 2> ends{};
  ASSERT_EQ(pipe(ends.data()), 0);
  ASSERT_EQ(fcntl(ends[1], F_SETPIPE_SZ, 4096), 4096) << "some five seconds of lines";
  const pid_t child = fork();
  if (child == 0) {
    dup2(ends[1], STDOUT_FILENO);
    execl(STRIATE_BINARY, STRIATE_BINARY, "drive", served.url().c_str(), "--forward-m-s", "0.65",
          "--way-m", "7", nullptr);
    _exit(98);
  }
  EXPECT_EQ(exit_code_within(child, 40s), 0);
  EXPECT_GT(served.state().true_pose.x_m, 6.5);
  for (const int end : ends) close(end);
}

/// Neither does a terminal whose output is held by Ctrl-S.
TEST(Endings, AHeldTerminalHoldsUpNoDrive) {
  const Served served;
  int terminal = -1;
  const pid_t child = forkpty(&terminal, nullptr, nullptr, nullptr);
  if (child == 0) become_drive(served.url());
  served.until([](auto& s) { return s.true_forward_m_s > 0.3; }, 20.0);
  const char ctrl_s = 0x13;
  EXPECT_EQ(write(terminal, &ctrl_s, 1), 1);
  std::this_thread::sleep_for(3s);
  EXPECT_GT(served.state().true_forward_m_s, kFull_m_s - 0.01);
  kill(child, SIGINT);
  const char ctrl_q = 0x11;
  std::this_thread::sleep_for(1s);
  EXPECT_EQ(write(terminal, &ctrl_q, 1), 1);
  std::array<char, 1024> chunk{};
  while (read(terminal, chunk.data(), chunk.size()) > 0) {
  }
  EXPECT_EQ(exit_code_within(child, 20s), 130);
  close(terminal);
}

}  // namespace
}  // namespace striate::scenarios
