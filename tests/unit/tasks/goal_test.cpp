#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "striate/config/diagnostics.hpp"
#include "striate/tasks/task_reader.hpp"

/// What a mission is after is a key of the script, whatever its variables are called.
namespace striate::tasks {
namespace {

using testing::HasSubstr;

Task task_of(const std::string& head) {
  config::Diagnostics diagnostics(std::string(STRIATE_SOURCE_DIR "/config/tasks/t.yaml"), 'T');
  Task task = read_task("striate: 1\n" + head + "do:\n  - stop: {}\n", diagnostics, {});
  EXPECT_TRUE(diagnostics.none()) << diagnostics.text();
  return task;
}

TEST(TaskGoal, IsTheStepsUnlessTheScriptSaysLine) {
  EXPECT_EQ(task_of("").goal, TaskGoal::steps);
  EXPECT_EQ(task_of("goal: steps\n").goal, TaskGoal::steps);
  EXPECT_EQ(task_of("goal: line\n").goal, TaskGoal::line);
  EXPECT_EQ(task_of("goal: line\n").notices, "");
}

TEST(TaskGoal, IsTheLineForAVariableCalledWayUntilTheNextVersionWithANoteThatSaysTheKey) {
  const Task old = task_of("vars: {cruise: 0.3 m/s, way: 12 m}\n");
  EXPECT_EQ(old.goal, TaskGoal::line);
  EXPECT_THAT(old.notices, HasSubstr("t.yaml:2:25: note: a variable 'way'"));
  EXPECT_THAT(old.notices, HasSubstr("'goal: line'"));
}

TEST(TaskGoal, IsWhatIsSaidAlsoBesideAVariableCalledWay) {
  const Task steps = task_of("goal: steps\nvars: {way: 12 m}\n");
  EXPECT_EQ(steps.goal, TaskGoal::steps);
  EXPECT_EQ(steps.notices, "");
  EXPECT_EQ(task_of("goal: line\nvars: {way: 12 m}\n").notices, "");
}

TEST(TaskGoal, IsNotThatOfAUsedTask) {
  config::Diagnostics diagnostics(std::string(STRIATE_SOURCE_DIR "/config/tasks/t.yaml"), 'T');
  const Task task =
      read_task("striate: 1\ndo:\n  - use: corridor.yaml\n", diagnostics, RobotDescription{});
  ASSERT_TRUE(diagnostics.none()) << diagnostics.text();
  EXPECT_EQ(task.goal, TaskGoal::steps);
  EXPECT_EQ(task.notices, "");
}

TEST(TaskGoal, CanBeAVariableAndIsShownInTheTree) {
  const Task task = task_of("mission: m\ngoal: $after\nvars: {after: line}\n");
  EXPECT_EQ(task.goal, TaskGoal::line);
  EXPECT_THAT(text_tree(task.outline), HasSubstr("task m  (until the goal line)\n"));
  EXPECT_THAT(xml_tree(task.outline), HasSubstr("<Task goal=\"line\">"));
  EXPECT_THAT(svg_tree(task.outline), HasSubstr("until the goal line"));
}

TEST(ShippedTasks, SayTheirGoalByItsKey) {
  for (const char* name : {"corridor", "round_trip", "explore", "find_and_return", "patrol", "seek",
                           "teach", "look"}) {
    const std::string file = std::string(STRIATE_SOURCE_DIR "/config/tasks/") + name + ".yaml";
    const Task task = load_task(file, RobotDescription{});
    EXPECT_EQ(task.notices, "") << file;
    EXPECT_EQ(task.goal == TaskGoal::line, std::string(name) == "corridor") << file;
  }
}

}  // namespace
}  // namespace striate::tasks
