#include "striate/tasks/task_reader.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "striate/base/user_error.hpp"

namespace striate::tasks {
namespace {

using testing::HasSubstr;

std::string diagnostics_of(const std::string& yaml) {
  config::Diagnostics diagnostics("t.yaml", 'T');
  read_task(yaml, diagnostics, RobotDescription{});
  return diagnostics.text();
}

TEST(TaskReader, ReadsStepsVariablesLimitsAndRecovery) {
  config::Diagnostics diagnostics("t.yaml", 'T');
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
      diagnostics, RobotDescription{});
  ASSERT_TRUE(diagnostics.none()) << diagnostics.text();
  EXPECT_EQ(task.mission, "there");
  EXPECT_EQ(task.goal, TaskGoal::steps);
  EXPECT_EQ(task.notices, "");
  ASSERT_TRUE(task.root);
  EXPECT_EQ(text_tree(task.outline),
            "task there\n"
            "├─ do\n"
            "│  ├─ traverse_corridor {speed: 0.3 m/s}  (until travelled: 12 m, within 4 min)\n"
            "│  │  └─ if_it_fails, 2 more tries\n"
            "│  │     └─ back_up {distance: 0.3 m}\n"
            "│  └─ stop\n"
            "└─ finally\n"
            "   └─ stop\n");
}

TEST(TaskReader, TellsAllDiagnosticsInOnePassWithTheirPlaces) {
  const std::string text = diagnostics_of(
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
  EXPECT_THAT(text, HasSubstr("t.yaml:1:10: error[T016]: '2' is out of range"));
  EXPECT_THAT(text, HasSubstr("t.yaml:2:1: error[T010]: unknown key 'misson' in the task"));
  EXPECT_THAT(text, HasSubstr("did you mean 'mission'?"));
  EXPECT_THAT(text, HasSubstr("t.yaml:5:5: error[T020]: unknown action 'traverse_coridor'"));
  EXPECT_THAT(text, HasSubstr("did you mean 'traverse_corridor'?"));
  EXPECT_THAT(text, HasSubstr("t.yaml:6:32: error[T025]: unknown variable '$cruse'"));
  EXPECT_THAT(text, HasSubstr("did you mean 'cruise'?"));
  EXPECT_THAT(text, HasSubstr("t.yaml:7:13: error[T014]: '4' has no unit"));
  EXPECT_THAT(text, HasSubstr("t.yaml:8:5: error[T020]: unknown action 'untill'"));
  EXPECT_THAT(text, HasSubstr("did you mean 'until'?"));
  EXPECT_THAT(text, HasSubstr("t.yaml:9:25: error[T015]: '3 s' has the wrong unit"));
  EXPECT_THAT(text, HasSubstr("t.yaml:10:13: error[T023]: unknown condition 'traveled'"));
  EXPECT_THAT(text, HasSubstr("did you mean 'travelled'?"));
  EXPECT_THAT(text, HasSubstr("t.yaml:12:5: error[T022]: this step has two actions"));
  EXPECT_THAT(text, HasSubstr("t.yaml:13:5: error[T012]: a step must be an action"));
  EXPECT_THAT(text, HasSubstr("t.yaml:15:10: error[T012]: 'finally' must be a list of steps"));
}

TEST(TaskReader, GivenValuesReplaceDeclaredVariablesOnly) {
  const std::string script =
      "striate: 1\nvars: {far: 3 m}\ndo:\n  - traverse_corridor: {}\n    until: {travelled: "
      "$far}\n";
  config::Diagnostics good("t.yaml");
  read_task(script, good, RobotDescription{}, {{"far", "5 m"}, {"other", "7 s"}});
  EXPECT_TRUE(good.none()) << good.text();
  config::Diagnostics bad("t.yaml");
  read_task(script, bad, RobotDescription{}, {{"far", "5 s"}});
  EXPECT_THAT(bad.text(), HasSubstr("'5 s' has the wrong unit"));
  EXPECT_THAT(bad.text(), HasSubstr("$far is '5 s', given from outside"));
}

TEST(TaskReader, AGoalAtTheEndOfItsTimeIsReached) {
  EXPECT_THAT(diagnostics_of("striate: 1\ndo:\n  - traverse_corridor: {}\n"
                             "    until: {after: 10 s}\n    within: 10 s\n"),
              testing::Not(HasSubstr("T033")));
}

TEST(TaskReader, SaysWhatIsMissing) {
  EXPECT_THAT(diagnostics_of("mission: x\n"), HasSubstr("the task needs 'striate'"));
  EXPECT_THAT(diagnostics_of("striate: 1\n"), HasSubstr("the task needs 'do'"));
  EXPECT_THAT(diagnostics_of("striate: 1\ndo: []\n"), HasSubstr("'do' has no steps"));
  EXPECT_THAT(diagnostics_of("striate: 1\ndo:\n  - within: 3 s\n"),
              HasSubstr("this step has no action"));
  EXPECT_THAT(diagnostics_of("- a\n"), HasSubstr("a task script must be a map"));
  EXPECT_THAT(diagnostics_of(""), HasSubstr("the file is empty"));
}

TEST(TaskReader, EveryShippedScriptIsGood) {
  int count = 0;
  const std::filesystem::path folder = std::string(STRIATE_SOURCE_DIR "/config/tasks");
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".yaml") continue;
    EXPECT_NO_THROW(load_task(entry.path().string(), RobotDescription{})) << entry.path();
    ++count;
  }
  EXPECT_GE(count, 1);
}

TEST(TaskReader, TakesAnActionsMainValueWithoutItsName) {
  config::Diagnostics diagnostics("t.yaml", 'T');
  const Task task =
      read_task("striate: 1\ndo:\n  - say: \"I see it\"\n  - wait: 3 s\n  - wait: 3 m\n",
                diagnostics, RobotDescription{});
  ASSERT_EQ(diagnostics.count(), 1U) << diagnostics.text();
  EXPECT_THAT(diagnostics.text(), HasSubstr("t.yaml:5:11: error[T015]: '3 m' has the wrong unit"));
  EXPECT_THAT(text_tree(task.outline), HasSubstr("say {text: I see it}\n   ├─ wait {for: 3 s}"));
}

TEST(TaskReader, ReadsEveryKindOfNode) {
  config::Diagnostics diagnostics("t.yaml", 'T');
  const Task task = read_task(
      "striate: 1\n"
      "mission: all\n"
      "always:\n"
      "  - pause_if: {image_older_than: 250 ms}\n"
      "do:\n"
      "  - try:\n"
      "      - back_up: {}\n"
      "      - stop: {}\n"
      "    only_if: {after: 0 s}\n"
      "  - together:\n"
      "      - drive_straight: {distance: 2 m}\n"
      "      - repeat: [look_at: {pan: 20 deg}]\n"
      "    until: {travelled: 1 m}\n"
      "  - repeat: {times: 2, do: [wait: 1 s]}\n"
      "    unless: {light_below: 10 %}\n"
      "    optional: true\n"
      "  - do:\n"
      "      - stop: {}\n",
      diagnostics, RobotDescription{});
  ASSERT_TRUE(diagnostics.none()) << diagnostics.text();
  EXPECT_EQ(text_tree(task.outline),
            "task all\n"
            "├─ always\n"
            "│  └─ pause_if image_older_than: 250 ms\n"
            "└─ do\n"
            "   ├─ try  (only if after: 0 s)\n"
            "   │  ├─ back_up\n"
            "   │  └─ stop\n"
            "   ├─ together  (until travelled: 1 m)\n"
            "   │  ├─ drive_straight {distance: 2 m}\n"
            "   │  └─ repeat\n"
            "   │     └─ look_at {pan: 20 deg}\n"
            "   ├─ repeat 2 times  (unless light_below: 10 %, optional)\n"
            "   │  └─ wait {for: 1 s}\n"
            "   └─ do\n"
            "      └─ stop\n");
}

}  // namespace
}  // namespace striate::tasks
