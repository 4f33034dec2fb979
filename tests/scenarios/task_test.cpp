#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <nlohmann/json.hpp>

#include "striate/agent/mission.hpp"
#include "striate/tasks/task_reader.hpp"
#include "tests/scenarios/short_world.hpp"
#include "tests/scenarios/striate_process.hpp"

namespace striate::scenarios {
namespace {

using testing::HasSubstr;

/// What was wanted and sent in a cycle, bit for bit.
std::string decision(const behaviours::Wish& wish, const MotorCommand& sent,
                     std::string_view action) {
  const double values[] = {wish.forward_m_s, wish.turn_rad_s, wish.pan_rad, wish.tilt_rad,
                           sent.forward_m_s, sent.turn_rad_s, sent.pan_rad, sent.tilt_rad};
  std::string bits(sizeof values, '\0');
  std::memcpy(bits.data(), values, sizeof values);
  return bits.append(action);
}

TEST(Decisions, AreTheSameBitForBitInASecondRunAndWhenMadeAgainFromWhatWasSensed) {
  std::vector<std::string> first;
  std::vector<std::string> second;
  for (std::vector<std::string>* run : {&first, &second}) {
    agent::Mission mission(shipped_task("corridor.yaml"), in_short_world());
    // The mind once more, beside the one that drives: it gets what was sensed and seen.
    const agent::RobotSettings settings = agent::load_robot_settings("");
    const RobotDescription& robot = mission.body().description();
    memory::ShortTermMemory memory(settings.memory, robot);
    tasks::Executive executive(
        tasks::load_task(shipped_task("corridor.yaml").task, robot, {{"way", "12.5 m"}}));
    behaviours::Arbiter arbiter;
    behaviours::SafetyLimiter limiter(settings.safety, robot);
    mission.run([&](const agent::Mission& running) {
      const agent::CycleTrace& trace = running.cycle().trace();
      run->push_back(decision(trace.wish, trace.sent, running.executive().current_action()));
      memory.update(trace.senses, trace.percept);
      const tasks::TaskDecision task = executive.tick(memory, trace.senses.now);
      const behaviours::Claim chosen = arbiter.decide({task.claim}, trace.senses.now);
      const MotorCommand sent = limiter.limit(chosen.wish, trace.senses, memory).command;
      memory.remember(sent, task.doing);
      const bool going = to_seconds(trace.senses.now) < 12.0;
      if (going) {
        EXPECT_EQ(run->back(), decision(task.claim.wish, sent, task.doing));
      }
      return !going;
    });
  }
  EXPECT_GT(first.size(), 100U);
  EXPECT_TRUE(first == second);
}

TEST(RoundTrip, GoesAlmostToTheEndAndComesBackByVisionAlone) {
  agent::MissionOptions options = shipped_task("round_trip.yaml");
  options.emergency_layer = false;
  agent::Mission mission(options, in_short_world());
  double farthest_m = 0.0;
  const agent::RunResult result = mission.run([&](const agent::Mission& running) {
    farthest_m = std::max(farthest_m, running.cycle().memory().progress_m());
    return to_seconds(running.cycle().trace().senses.now) > 240.0;
  });
  EXPECT_EQ(result.outcome, agent::RunOutcome::success) << result.reason;
  EXPECT_TRUE(result.collisions.empty());
  EXPECT_FALSE(result.reached_goal);
  EXPECT_GT(farthest_m, 9.0);
  EXPECT_NEAR(mission.cycle().memory().progress_m(), 1.0, 0.4);
  EXPECT_GT(result.distance_m, 17.0);
}

TEST(Explore, GoesRoundTheBendOfAnUnknownCorridorAndComesBack) {
  const TemporaryFolder folder;
  const std::string world = folder.write("bend.yaml", R"(striate_world: 1
name: bend
corridor: {length: 10 m, width: 2.2 m, height: 2.7 m}
turns: [{at: 5 m, angle: 90 deg}]
walls:
  - {side: left, from: 1 m, to: 4 m, material: brick}
  - {side: right, from: 3 m, to: 6 m, material: wallpaper}
  - {side: left, from: 6.5 m, to: 9 m, material: panelling}
doors: [{side: right, at: 2 m}]
posters: [{side: right, at: 7.5 m, image: poster_map}]
lights: [{from: 0 m, to: 10 m, every: 2.5 m, level: 1.0}]
start: {at: [1.0 m, 0 m], heading: 0 deg}
goal: {beyond: 7.5 m}
)");
  agent::MissionOptions options;
  options.task = folder.write("short.yaml", "striate: 1\ndo:\n  - use: " + kRoot +
                                                "config/tasks/explore.yaml\n"
                                                "    with: {longest: 90 s}\n");
  options.emergency_layer = false;
  agent::Mission mission(options, agent::simulated_pioneer({.world = world, .seed = 3}));
  const agent::RunResult result = mission.run([](const agent::Mission&) { return false; });
  EXPECT_EQ(result.outcome, agent::RunOutcome::success) << result.reason;
  EXPECT_TRUE(result.reached_goal) << "round the bend";
  EXPECT_TRUE(result.collisions.empty());
  ASSERT_TRUE(result.from_start_m.has_value());
  EXPECT_LT(*result.from_start_m, 0.8);
}

TEST(SmallMission, SaysItsTextAndSucceedsWithItsStepsOrFailsWithAReason) {
  const TemporaryFolder folder;
  const std::string good =
      folder.write("good.yaml",
                   "striate: 1\ndo:\n  - say: hello\n  - try:\n      - turn_to: {by: 90 deg}\n"
                   "        within: 0.3 s\n      - say: I cannot turn\nfinally:\n  - stop: {}\n");
  const Ended said = striate({"run", good, "--world", "config/worlds/short.yaml"});
  EXPECT_EQ(said.exit_code, 0) << said.out;
  EXPECT_THAT(said.err, HasSubstr("says: hello\n"));
  EXPECT_THAT(said.err, HasSubstr("says: I cannot turn\n"));
  const std::string bad =
      folder.write("bad.yaml",
                   "striate: 1\nalways:\n  - fail_if: {after: 1 s}\ndo:\n  - wait: 9 s\nfinally:\n"
                   "  - say: bye\n");
  const Ended failed = striate({"run", bad, "--world", "config/worlds/short.yaml"});
  EXPECT_EQ(failed.exit_code, 1);
  EXPECT_THAT(failed.out, HasSubstr("task_failed (guard (line 3): after: 1 s)"));
  EXPECT_THAT(failed.err, HasSubstr("says: bye\n"));
}

TEST(TaskCommand, ShowsTheTreeAsTextImageAndXml) {
  const TemporaryFolder folder;
  const Ended text = striate({"task", "show", "config/tasks/round_trip.yaml"});
  EXPECT_EQ(text.exit_code, 0) << text.err;
  EXPECT_THAT(text.out,
              HasSubstr("task round_trip\n├─ do\n│  ├─ traverse_corridor {speed: 0.5 m/s"));
  const Ended files = striate({"task", "show", "config/tasks/round_trip.yaml", "--svg",
                               folder / "t.svg", "--xml", folder / "t.xml"});
  EXPECT_EQ(files.exit_code, 0) << files.err;
  EXPECT_THAT(read_text(folder / "t.svg"), HasSubstr("<svg "));
  EXPECT_THAT(read_text(folder / "t.xml"), HasSubstr("<root BTCPP_format=\"4\""));
}

TEST(TaskCommand, ListsTheActionsAlsoAsJson) {
  const Ended text = striate({"task", "actions"});
  EXPECT_EQ(text.exit_code, 0);
  EXPECT_THAT(text.out, HasSubstr("traverse_corridor"));
  const Ended json = striate({"task", "actions", "--json"});
  EXPECT_EQ(json.exit_code, 0);
  EXPECT_GE(nlohmann::json::parse(json.out).at("actions").size(), 10U);
}

TEST(TaskCommand, CheckTellsEveryDiagnosticOfATaskThatIsNotEvenYaml) {
  const Ended ended = striate(
      {"check", "tests/broken_tasks/42_not_yaml.yaml", "tests/broken_tasks/48_many_at_once.yaml"});
  EXPECT_EQ(ended.exit_code, 2);
  EXPECT_THAT(ended.err, HasSubstr("42_not_yaml.yaml:3:12: error[T001]: not readable as YAML"));
  EXPECT_THAT(ended.err, HasSubstr("mistakes in tests/broken_tasks/48_many_at_once.yaml"));
}

}  // namespace
}  // namespace striate::scenarios
