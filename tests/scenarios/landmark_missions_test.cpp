#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/scenarios/striate_process.hpp"

/// The robot is taught two books; missions that need them.
namespace striate::scenarios {
namespace {

using testing::HasSubstr;
using Words = std::vector<std::string>;

Words operator+(Words words, const Words& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

const Words kSharpEyes = {"--robot", "config/robots/sharp_eyes.yaml"};

Words run(const std::string& task, const std::string& world) {
  return Words{"run", task, "--world", "config/worlds/" + world + ".yaml", "--quiet"} + kSharpEyes;
}

class TaughtBooks : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = std::make_unique<TemporaryFolder>();
    red_ = teach("red_book", "2 m, 0.2 m, 90 deg");
    blue_ = teach("blue_book", "9.5 m, -0.2 m, -90 deg");
  }
  static void TearDownTestSuite() { folder_.reset(); }

  static Ended teach(const std::string& name, const std::string& from) {
    return striate(Words{"teach", name, "--task", "config/tasks/teach.yaml", "--world",
                         "config/worlds/objects_teach.yaml", "--at", from, "--yes", "--memory",
                         *folder_ / "taught.db"} +
                   kSharpEyes);
  }

  /// A memory of the books that no mission has changed.
  static std::string memory(const std::string& name) {
    const std::string copy = *folder_ / name;
    std::filesystem::copy_file(*folder_ / "taught.db", copy);
    return copy;
  }

  static nlohmann::json look(const std::string& memory, const Words& words) {
    const Ended ended = striate(Words{"memory", memory} + words + Words{"--json"});
    EXPECT_EQ(ended.exit_code, 0) << ended.err;
    return nlohmann::json::parse(ended.out, nullptr, false);
  }

  static nlohmann::json result_of(const Words& words) {
    const std::string file = *folder_ / "result.json";
    const Ended ended = striate(words + Words{"--result", file});
    EXPECT_EQ(ended.exit_code, 0) << ended.err;
    return nlohmann::json::parse(read_text(file), nullptr, false);
  }

  static std::unique_ptr<TemporaryFolder> folder_;
  static Ended red_;
  static Ended blue_;
};

std::unique_ptr<TemporaryFolder> TaughtBooks::folder_;
Ended TaughtBooks::red_;
Ended TaughtBooks::blue_;

TEST_F(TaughtBooks, WereLookedAtFromAllSides) {
  ASSERT_EQ(red_.exit_code, 0) << red_.err;
  ASSERT_EQ(blue_.exit_code, 0) << blue_.err;
  EXPECT_THAT(red_.out, HasSubstr("red_book: new, 4 views added"));
  EXPECT_EQ(look(memory("looks.db"), {"show", "red_book"}).at("looks").size(), 4U);
}

TEST_F(TaughtBooks, AreKnownAgainAndTheRecordingOfThatDecidesTheSame) {
  const std::string home = memory("home.db");
  const std::string task = folder_->write("t.yaml", "striate: 1\ndo:\n  - wait: {for: 2 s}\n");
  const std::string recording = *folder_ / "run.rec";
  const Ended ended =
      striate(run(task, "objects_teach") + Words{"--memory", home, "--record", recording});
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  const nlohmann::json episodes = look(home, {"episodes"});
  ASSERT_EQ(episodes.size(), 5U) << "taught twice, start, recognised, end";
  EXPECT_EQ(episodes[3].at("kind"), "recognised");
  EXPECT_EQ(episodes[3].at("landmark"), "red_book");
  EXPECT_THAT(episodes[3].at("text").get<std::string>(), HasSubstr("1.5 m away"));
  const Ended again = striate({"replay", recording});
  EXPECT_EQ(again.exit_code, 0) << again.err;
  EXPECT_THAT(again.out, HasSubstr("the same in all cycles, bit for bit"));
}

// The experiment of 2012: two things stand in the way back that did not on the way out.
TEST_F(TaughtBooks, OneIsFoundAndTheStartAgainAlthoughNewThingsStandInTheWay) {
  const auto result = result_of(run("config/tasks/find_and_return.yaml", "find_and_return") +
                                Words{"--memory", memory("find.db")});
  EXPECT_EQ(result.at("outcome"), "success");
  EXPECT_TRUE(result.at("collisions").empty());
  ASSERT_EQ(result.at("late_obstacles").size(), 2U);
  for (const auto& late : result.at("late_obstacles")) EXPECT_TRUE(late.at("put_down")) << late;
  EXPECT_GT(result.at("distance_m").get<double>(), 10.0) << "the book stands 8 m away";
  EXPECT_LT(result.at("from_start_m").get<double>(), 0.8);
}

TEST_F(TaughtBooks, ArePatrolledBetween) {
  const std::string patrolled = memory("patrol.db");
  const auto result = result_of(run("config/tasks/patrol.yaml", "patrol") +
                                Words{"--memory", patrolled, "--var", "rounds=1"});
  EXPECT_EQ(result.at("outcome"), "success");
  EXPECT_TRUE(result.at("collisions").empty());
  EXPECT_GT(result.at("distance_m").get<double>(), 5.0) << "to the one, and to the other";
  const std::string episodes = look(patrolled, {"episodes"}).dump();
  EXPECT_THAT(episodes, HasSubstr(R"("kind":"recognised","landmark":"red_book")"));
  EXPECT_THAT(episodes, HasSubstr(R"("kind":"recognised","landmark":"blue_book")"));
}

TEST(LandmarkMissions, WhatWasNeverTaughtIsMissedBeforeTheRobotMoves) {
  const TemporaryFolder folder;
  const Ended ended = striate(run("config/tasks/find_and_return.yaml", "find_and_return") +
                              Words{"--memory", folder / "home.db"});
  EXPECT_EQ(ended.exit_code, 2);
  EXPECT_THAT(ended.err, HasSubstr("red_book"));
}

}  // namespace
}  // namespace striate::scenarios
