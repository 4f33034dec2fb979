#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/scenarios/striate_process.hpp"

/// Missions that need a landmark which was taught before.
namespace striate::scenarios {
namespace {

using testing::HasSubstr;

const std::vector<std::string> kFindAndReturn = {"run",     "config/tasks/find_and_return.yaml",
                                                 "--world", "config/worlds/find_and_return.yaml",
                                                 "--robot", "config/robots/sharp_eyes.yaml",
                                                 "--seed",  "1",
                                                 "--quiet", "--memory"};

std::vector<std::string> with(std::vector<std::string> words,
                              const std::vector<std::string>& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

// The experiment of 2012: two things stand in the way back that did not on the way out.
TEST(LandmarkMissions, TheBookIsFoundAndTheStartAgainAlthoughNewThingsStandInTheWay) {
  const TemporaryFolder folder;
  const std::string memory = folder / "home.db";
  const Ended taught = striate({"teach", "red_book", "--task", "config/tasks/teach.yaml", "--robot",
                                "config/robots/sharp_eyes.yaml", "--world",
                                "config/worlds/objects_teach.yaml", "--yes", "--memory", memory});
  ASSERT_EQ(taught.exit_code, 0) << taught.err;

  const std::string file = folder / "result.json";
  const Ended run = striate(with(kFindAndReturn, {memory, "--result", file}));
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const auto result = nlohmann::json::parse(read_text(file));
  EXPECT_EQ(result.at("outcome"), "success");
  EXPECT_TRUE(result.at("collisions").empty());
  EXPECT_GT(result.at("distance_m").get<double>(), 10.0) << "the book stands 8 m away";
  EXPECT_LT(result.at("from_start_m").get<double>(), 0.8);
}

TEST(LandmarkMissions, WhatWasNeverTaughtIsMissedBeforeTheRobotMoves) {
  const TemporaryFolder folder;
  const Ended run = striate(with(kFindAndReturn, {folder / "home.db"}));
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.err, HasSubstr("red_book"));
}

}  // namespace
}  // namespace striate::scenarios
