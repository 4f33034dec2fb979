#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/scenarios/striate_process.hpp"

/// Things so low that the eyes do not see them: sonar stops the robot, and it goes round.
namespace striate::scenarios {
namespace {

TEST(LowThings, WhatStoppedTheRobotUnseenIsGoneRound) {
  const TemporaryFolder folder;
  const std::string world = folder.write(
      "low.yaml",
      "striate_world: 1\n"
      "name: low\n"
      "corridor: {length: 11 m, width: 2.0 m}\n"
      "lights: [{from: 0 m, to: 11 m, every: 4 m, level: 0.8}]\n"
      "obstacles: [{kind: cardboard_box, at: [5 m, 0 m], size: [0.35 m, 0.3 m, 0.12 m]}]\n"
      "start: {at: [1 m, 0 m]}\n"
      "goal: {beyond: 9 m}\n");
  const Ended ended = striate({"run", "config/tasks/corridor.yaml", "--world", world, "--quiet",
                               "--result", folder / "r.json"});
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  const nlohmann::json result = nlohmann::json::parse(read_text(folder / "r.json"));
  EXPECT_EQ(result.at("outcome"), "success") << result.at("reason");
  EXPECT_TRUE(result.at("collisions").empty());
  EXPECT_GE(result.at("emergency_stops").get<int>(), 1) << "nothing was in its way";
  EXPECT_LE(result.at("emergency_stops").get<int>(), 6);
}

}  // namespace
}  // namespace striate::scenarios
