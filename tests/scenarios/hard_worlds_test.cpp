#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/scenarios/striate_process.hpp"

namespace striate::scenarios {
namespace {

nlohmann::json driven(const std::string& world, const std::string& seed,
                      const std::vector<std::string>& more) {
  const TemporaryFolder folder;
  std::vector<std::string> command = {"run",      "config/tasks/corridor.yaml",
                                      "--world",  "config/worlds/" + world + ".yaml",
                                      "--seed",   seed,
                                      "--quiet",  "--no-emergency",
                                      "--result", folder / "r.json"};
  command.insert(command.end(), more.begin(), more.end());
  const Ended ended = striate(command);
  EXPECT_EQ(ended.exit_code, 0) << world << ": " << ended.err << ended.out;
  return nlohmann::json::parse(read_text(folder / "r.json"));
}

class HardWorld : public testing::TestWithParam<const char*> {};

// The paper's three causes of failure, each in a world of its own.
TEST_P(HardWorld, IsDrivenByVisionAloneWithoutTouching) {
  const nlohmann::json result = driven(GetParam(), "1", {});
  EXPECT_EQ(result.at("outcome"), "success") << result.at("reason");
  EXPECT_TRUE(result.at("collisions").empty());
  EXPECT_LT(result.at("longest_stand_s"), 30.0);
}

INSTANTIATE_TEST_SUITE_P(CausesOfFailure, HardWorld,
                         testing::Values("hard_dark_people", "hard_blank_wall", "hard_narrow"));

class OtherEyes : public testing::TestWithParam<const char*> {};

TEST_P(OtherEyes, DriveTheSameBehavioursAndAreNamedInTheResult) {
  const nlohmann::json result = driven("short", "1", {"--baseline", GetParam()});
  EXPECT_EQ(result.at("outcome"), "success") << result.at("reason");
  EXPECT_EQ(result.at("baseline"), GetParam());
}

INSTANTIATE_TEST_SUITE_P(Baselines, OtherEyes, testing::Values("sgbm", "truth"));

TEST(OtherEyes, ThatAreNotKnownAreADiagnosticOfTheUser) {
  const Ended ended = striate({"run", "config/tasks/corridor.yaml", "--world",
                               "config/worlds/short.yaml", "--baseline", "eagle"});
  EXPECT_EQ(ended.exit_code, 2);
  EXPECT_NE(ended.err.find("{paper,sgbm,truth}"), std::string::npos) << ended.err;
}

}  // namespace
}  // namespace striate::scenarios
