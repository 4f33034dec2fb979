#include "striate/app/commands/action_list.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "striate/tasks/task_reader.hpp"

namespace striate::app {
namespace {

TEST(ActionList, EveryExampleIsAGoodStep) {
  const auto json = actions_as_json();
  EXPECT_EQ(json.at("actions").size(), behaviours::behaviour_registry().size());
  for (const auto& action : json.at("actions")) {
    config::Diagnostics diagnostics("t.yaml", 'T');
    const std::string example = action.at("example");
    tasks::read_task("striate: 1\ndo:\n  " + example + "\n", diagnostics, RobotDescription{});
    EXPECT_TRUE(diagnostics.none()) << diagnostics.text();
  }
  for (const auto& condition : json.at("conditions")) {
    config::Diagnostics diagnostics("t.yaml", 'T');
    const std::string example = condition.at("example");
    tasks::read_task("striate: 1\ndo:\n  - traverse_corridor: {}\n    " + example + "\n",
                     diagnostics, RobotDescription{});
    EXPECT_TRUE(diagnostics.none()) << diagnostics.text();
  }
}

TEST(ActionList, TellsDefaultsRangesAndWhatMustBeGiven) {
  const std::string text = actions_as_text();
  EXPECT_THAT(text, testing::HasSubstr("  back_up: drives straight back\n"
                                       "      - back_up: {distance: 0.3 m, speed: 0.12 m/s, "
                                       "known_floor: false}\n"));
  EXPECT_THAT(text, testing::ContainsRegex("      distance +0.3 m +how far \\(0.02 m .. 5 m\\)"));
  EXPECT_THAT(text, testing::ContainsRegex("      text +\\(must be given\\) +what is said"));
  EXPECT_THAT(text, testing::HasSubstr("{battery_below: 20 %}"));
  EXPECT_THAT(text, testing::HasSubstr("- look_around: {pan: 60 deg, dwell: 0.7 s}"));
  EXPECT_THAT(text, testing::HasSubstr("(2.865 deg .. 91.67 deg)"));
}

}  // namespace
}  // namespace striate::app
