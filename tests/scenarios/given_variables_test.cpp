#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/scenarios/refused.hpp"

namespace striate::scenarios {
namespace {

TEST(GivenVariables, AGivenVariableGoesBeforeTheWorldsCourse) {
  const TemporaryFolder folder;
  const std::string result = folder / "r.json";
  const Ended ended =
      striate({"run", "config/tasks/corridor.yaml", "--world", "config/worlds/short.yaml", "--var",
               "way=2 m", "--quiet", "--result", result});
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  const auto json = nlohmann::json::parse(read_text(result));
  EXPECT_EQ(json.at("outcome"), "success");
  EXPECT_NEAR(json.at("distance_m").get<double>(), 2.4, 0.5) << "2 m along, some to the side";
  EXPECT_FALSE(json.at("reached_goal").get<bool>());
}

TEST(GivenVariables, AnUnknownVariableNamesTheNearest) {
  const Words run = {"run", "config/tasks/corridor.yaml", "--world", "config/worlds/short.yaml",
                     "--var"};
  expect_refused({
      {with(run, "wya=2 m"), "has no variable 'wya'\n  hint: did you mean 'way'?"},
      {with(run, "way"), "is no variable\n  hint: --var \"way=20 m\""},
      {with(run, "way=2 s"), "corridor.yaml:"},
  });
}

}  // namespace
}  // namespace striate::scenarios
