#include "striate/platform/rosbridge/twist_keeper.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <functional>

#include "tests/unit/rosbridge/bridge_server.hpp"

namespace striate::rosbridge {
namespace {

using namespace std::chrono_literals;

bool within_ten_seconds(const std::function<bool()>& wanted) {
  for (int i = 0; i < 1000 && !wanted(); ++i) std::this_thread::sleep_for(10ms);
  return wanted();
}

BridgeSettings keeper_settings(const BridgeServer& server) {
  BridgeSettings settings;
  settings.url = server.url();
  return settings;
}

/// A program that drives and then says nothing more. @return its process
pid_t mind_that_hangs(const BridgeSettings& settings) {
  const pid_t mind = fork();
  if (mind != 0) return mind;
  const auto keeper = make_twist_keeper(settings);
  keeper->hear(true);
  pause();
  _exit(0);
}

TEST(TwistKeeper, SaysZeroWhenTheMindHangsAndWhenItDies) {
  BridgeServer server;
  const pid_t mind = mind_that_hangs(keeper_settings(server));
  EXPECT_TRUE(within_ten_seconds([&] { return !server.speeds_m_s().empty(); }));
  kill(mind, SIGKILL);
  waitpid(mind, nullptr, 0);
  EXPECT_TRUE(within_ten_seconds([&] {
    const auto heard = server.heard();
    return heard.back().at("op") == "publish" && server.speeds_m_s().size() > 10;
  }));
  for (const double speed_m_s : server.speeds_m_s()) EXPECT_EQ(speed_m_s, 0.0);
}

TEST(TwistKeeper, SaysNothingWhileTheMindSpeaksAndAfterAnEndOnPurpose) {
  BridgeServer server;
  {
    const auto keeper = make_twist_keeper(keeper_settings(server));
    ASSERT_TRUE(within_ten_seconds([&] { return !server.heard().empty(); }));
    for (int i = 0; i < 10; ++i) {
      keeper->hear(true);
      std::this_thread::sleep_for(50ms);
    }
  }
  std::this_thread::sleep_for(300ms);
  EXPECT_TRUE(server.speeds_m_s().empty());
}

}  // namespace
}  // namespace striate::rosbridge
