#include "tasks/task_reader.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "config/user_error.hpp"

namespace striate {
namespace {

using testing::HasSubstr;

std::string mistakes_of(const std::string& yaml) {
  config::Mistakes mistakes("t.yaml");
  read_task(yaml, mistakes, RobotDescription{});
  return mistakes.text();
}

TEST(TaskReader, ReadsStepsVariablesLimitsAndRecovery) {
  config::Mistakes mistakes("t.yaml");
  const Task task = read_task(
      "striate: 1\n"
      "mission: there\n"
      "vars: {cruise: 0.3 m/s, far: 12 m}\n"
      "do:\n"
      "  - traverse_corridor: {speed: $cruise}\n"
      "    until: {travelled: $far}\n"
      "    within: 4 min\n"
      "    if_it_fails:\n"
      "      tries: 2\n"
      "      do:\n"
      "        - back_up: {distance: 0.3 m}\n"
      "  - stop: {}\n"
      "finally:\n"
      "  - stop:\n",
      mistakes, RobotDescription{});
  ASSERT_TRUE(mistakes.none()) << mistakes.text();
  EXPECT_EQ(task.mission, "there");
  ASSERT_EQ(task.steps.size(), 2U);
  EXPECT_EQ(task.steps[0].action, "traverse_corridor");
  EXPECT_EQ(task.steps[0].place.line, 5);
  ASSERT_TRUE(task.steps[0].behaviour);
  ASSERT_TRUE(task.steps[0].until);
  EXPECT_EQ(task.steps[0].within, Duration(std::chrono::minutes(4)));
  ASSERT_TRUE(task.steps[0].if_it_fails);
  EXPECT_EQ(task.steps[0].if_it_fails->tries, 2);
  EXPECT_EQ(task.steps[0].if_it_fails->steps.size(), 1U);
  EXPECT_EQ(task.finally.size(), 1U);
}

TEST(TaskReader, TellsAllMistakesInOnePassWithTheirPlaces) {
  const std::string text = mistakes_of(
      "striate: 2\n"                              // 1: version
      "misson: x\n"                               // 2: unknown key
      "vars: {cruise: 0.3 m/s}\n"                 // 3
      "do:\n"                                     // 4
      "  - traverse_coridor: {speed: 0.3 m/s}\n"  // 5: unknown action
      "  - traverse_corridor: {speed: $cruse}\n"  // 6: unknown variable
      "    within: 4\n"                           // 7: no unit
      "    untill: {travelled: 3 m}\n"            // 8: unknown key
      "  - back_up: {distance: 3 s}\n"            // 9: wrong unit
      "    until: {traveled: 3 m}\n"              // 10: unknown condition
      "  - stop: {}\n"                            // 11
      "    back_up: {distance: 0.2 m}\n"          // 12: second action
      "  - wait\n"                                // 13: no map
      "    \n"
      "finally: {stop: {}}\n");  // 15: no list
  EXPECT_THAT(text, HasSubstr("t.yaml:1:10: error: '2' is out of range"));
  EXPECT_THAT(text, HasSubstr("t.yaml:2:1: error: unknown key 'misson' in the task"));
  EXPECT_THAT(text, HasSubstr("did you mean 'mission'?"));
  EXPECT_THAT(text, HasSubstr("t.yaml:5:5: error: unknown action 'traverse_coridor'"));
  EXPECT_THAT(text, HasSubstr("did you mean 'traverse_corridor'?"));
  EXPECT_THAT(text, HasSubstr("t.yaml:6:32: error: unknown variable '$cruse'"));
  EXPECT_THAT(text, HasSubstr("did you mean 'cruise'?"));
  EXPECT_THAT(text, HasSubstr("t.yaml:7:13: error: '4' has no unit"));
  EXPECT_THAT(text, HasSubstr("t.yaml:8:5: error: unknown action 'untill'"));
  EXPECT_THAT(text, HasSubstr("did you mean 'until'?"));
  EXPECT_THAT(text, HasSubstr("t.yaml:9:25: error: '3 s' has the wrong unit"));
  EXPECT_THAT(text, HasSubstr("t.yaml:10:13: error: unknown condition 'traveled'"));
  EXPECT_THAT(text, HasSubstr("did you mean 'travelled'?"));
  EXPECT_THAT(text, HasSubstr("t.yaml:12:5: error: this step has two actions"));
  EXPECT_THAT(text, HasSubstr("t.yaml:13:5: error: a step must be an action"));
  EXPECT_THAT(text, HasSubstr("t.yaml:15:10: error: 'finally' must be a list of steps"));
}

TEST(TaskReader, GivenValuesReplaceDeclaredVariablesOnly) {
  const std::string script =
      "striate: 1\nvars: {far: 3 m}\ndo:\n  - wait: {}\n    until: {travelled: $far}\n";
  config::Mistakes good("t.yaml");
  read_task(script, good, RobotDescription{}, {{"far", "5 m"}, {"other", "7 s"}});
  EXPECT_TRUE(good.none()) << good.text();
  config::Mistakes bad("t.yaml");
  read_task(script, bad, RobotDescription{}, {{"far", "5 s"}});
  EXPECT_THAT(bad.text(), HasSubstr("'5 s' has the wrong unit"));
}

TEST(TaskReader, SaysWhatIsMissing) {
  EXPECT_THAT(mistakes_of("mission: x\n"), HasSubstr("the task needs 'striate'"));
  EXPECT_THAT(mistakes_of("striate: 1\n"), HasSubstr("the task needs 'do'"));
  EXPECT_THAT(mistakes_of("striate: 1\ndo: []\n"), HasSubstr("'do' has no steps"));
  EXPECT_THAT(mistakes_of("striate: 1\ndo:\n  - within: 3 s\n"),
              HasSubstr("this step has no action"));
  EXPECT_THAT(mistakes_of("- a\n"), HasSubstr("a task script must be a map"));
  EXPECT_THAT(mistakes_of(""), HasSubstr("the file is empty"));
}

TEST(TaskReader, EveryShippedScriptIsGood) {
  int count = 0;
  const std::filesystem::path folder = std::string(STRIATE_SOURCE_DIR) + "/config/tasks";
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".yaml") continue;
    EXPECT_NO_THROW(load_task(entry.path().string(), RobotDescription{})) << entry.path();
    ++count;
  }
  EXPECT_GE(count, 1);
}

}  // namespace
}  // namespace striate
