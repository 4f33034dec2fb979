#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <thread>

#include "tests/scenarios/taught_memory.hpp"

namespace striate::scenarios {
namespace {

using testing::AllOf;
using testing::HasSubstr;

/// A mission that stands for a while, started and not waited for.
pid_t start_mission(const std::string& task, const std::string& file) {
  const pid_t child = fork();
  if (child == 0) {
    if (chdir(STRIATE_SOURCE_DIR) != 0) _exit(99);
    execl(STRIATE_BINARY, "striate", "run", task.c_str(), "--world", "config/worlds/empty.yaml",
          "--quiet", "--memory", file.c_str(), nullptr);
    _exit(98);
  }
  return child;
}

TEST(MissionMemory, CanBeLookedIntoWhileItRunsAndSurvivesKillNine) {
  const TemporaryFolder folder;
  const std::string file = folder / "home.db";
  const std::string task = folder.write("t.yaml", "striate: 1\ndo:\n  - wait: {for: 600 s}\n");
  teach(file, "book", image_of_a_thing(folder, 1));
  const pid_t mission = start_mission(task, file);
  nlohmann::json episodes;
  for (int k = 0; k < 300 && episodes.size() < 2; ++k) {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    episodes = memory_json(file, {"episodes"});
  }
  EXPECT_EQ(episodes.back().at("kind"), "start");
  EXPECT_EQ(memory_json(file, {"list"}).size(), 1U);
  EXPECT_EQ(memory(file, {"forget", "book"}).exit_code, 0);
  EXPECT_THAT(striate({"teach", "x", "--image", folder / "thing_1.png", "--memory", file}).err,
              AllOf(HasSubstr("striate run (process"), HasSubstr("is writing into this memory")));
  kill(mission, SIGKILL);
  waitpid(mission, nullptr, 0);
  const Ended next =
      striate({"teach", "cup", "--image", image_of_a_thing(folder, 2), "--memory", file});
  EXPECT_EQ(next.exit_code, 0);
  EXPECT_THAT(next.err,
              AllOf(HasSubstr("(mission) ended without closing"), HasSubstr("found no damage")));
  EXPECT_EQ(memory_json(file, {"list", "--all"}).size(), 2U);
}

TEST(MissionMemory, ATaskThatNeedsALandmarkIsCheckedAgainstIt) {
  const TemporaryFolder folder;
  const std::string file = folder / "home.db";
  const std::string task =
      folder.write("t.yaml", "striate: 1\nneeds: {landmarks: [book]}\ndo:\n  - wait: {for: 1 s}\n");
  const auto run = [&] {
    return striate(
        {"run", task, "--world", "config/worlds/empty.yaml", "--quiet", "--memory", file});
  };
  EXPECT_EQ(run().exit_code, 2);
  EXPECT_FALSE(std::filesystem::exists(file));
  for (const char* how : {"run", "trial"}) {
    const Ended without =
        how == std::string("run")
            ? striate({"run", task, "--world", "config/worlds/empty.yaml", "--quiet"})
            : striate({"trial", "--task", task, "--worlds", "config/worlds/empty.yaml", "--runs",
                       "1", "--out", folder / "out"});
    EXPECT_EQ(without.exit_code, 2) << how;
    EXPECT_THAT(without.err, AllOf(HasSubstr("t.yaml:2:21"), HasSubstr("--memory FILE"))) << how;
  }
  teach(file, "bok", image_of_a_thing(folder, 1));
  EXPECT_THAT(run().err, HasSubstr("the memory knows no landmark 'book'"));
  teach(file, "book", image_of_a_thing(folder, 2));
  EXPECT_EQ(run().exit_code, 0);
}

TEST(MissionMemory, KeepsStartAndEndAndTheOperatingTime) {
  const TemporaryFolder folder;
  const std::string file = folder / "home.db";
  const std::string task = folder.write("t.yaml", "striate: 1\ndo:\n  - wait: {for: 2 s}\n");
  for (int run = 0; run < 2; ++run) {
    const Ended ended =
        striate({"run", task, "--world", "config/worlds/empty.yaml", "--quiet", "--memory", file});
    EXPECT_EQ(ended.exit_code, 0);
    EXPECT_EQ(ended.err, "");
  }
  const nlohmann::json episodes = memory_json(file, {"episodes"});
  ASSERT_EQ(episodes.size(), 4U);
  EXPECT_EQ(episodes[1].at("kind"), "end");
  EXPECT_THAT(episodes[1].at("text").get<std::string>(), HasSubstr("success"));
  EXPECT_GE(episodes[2].at("time_s"), 2.0);
  EXPECT_EQ(episodes[2].at("time_s"), episodes[1].at("time_s"));
}

}  // namespace
}  // namespace striate::scenarios
