#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <thread>

#include "tests/scenarios/exit_code_within.hpp"
#include "tests/scenarios/striate_process.hpp"

/// What is written of a mission that a signal ends.
namespace striate::scenarios {
namespace {

using namespace std::chrono_literals;

/// The result of a mission that gets these signals while it drives, 250 ms apart.
nlohmann::json result_after(const std::vector<int>& signals) {
  const TemporaryFolder folder;
  const std::string file = folder / "r.json";
  const std::string now = folder / "now.json";
  const pid_t child = fork();
  if (child == 0) {
    if (chdir(STRIATE_SOURCE_DIR) != 0) _exit(99);
    execl(STRIATE_BINARY, STRIATE_BINARY, "run", "config/tasks/corridor.yaml", "--world",
          "config/worlds/corridor_a.yaml", "--seed", "3", "--quiet", "--result", file.c_str(),
          "--inspect", now.c_str(), nullptr);
    _exit(98);
  }
  const auto end = std::chrono::steady_clock::now() + 60s;
  while (!std::filesystem::exists(now) && std::chrono::steady_clock::now() < end) {
    std::this_thread::sleep_for(20ms);
  }
  for (const int signal : signals) {
    kill(child, signal);
    std::this_thread::sleep_for(250ms);
  }
  EXPECT_EQ(exit_code_within(child, 60s), 130);
  return nlohmann::json::parse(read_text(file), nullptr, false);
}

TEST(Endings, AMissionThatIsEndedByASignalWritesItsResult) {
  for (const int signal : {SIGHUP, SIGPIPE, SIGQUIT, SIGXFSZ, SIGUSR2, SIGTERM}) {
    const auto result = result_after({signal});
    ASSERT_TRUE(result.is_object()) << signal;
    EXPECT_EQ(result.at("outcome"), "interrupted") << signal;
  }
}

TEST(Endings, AMissionThatIsInterruptedTwiceWritesItsResult) {
  const auto result = result_after({SIGINT, SIGINT});
  ASSERT_TRUE(result.is_object());
  EXPECT_EQ(result.at("outcome"), "interrupted");
}

}  // namespace
}  // namespace striate::scenarios
