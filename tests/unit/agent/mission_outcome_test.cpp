#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <stdexcept>

#include "striate/agent/mission.hpp"
#include "striate/agent/run_result.hpp"
#include "striate/platform/simulator/simulated_pioneer.hpp"
#include "striate/platform/simulator/world_reader.hpp"
#include "tests/reference/temporary_folder.hpp"

/// How a mission comes out, with and without a judge: every outcome of the table is reached here.
namespace striate::agent {
namespace {

using reference::TemporaryFolder;

/// A blind Pioneer in a short corridor, with a judge: quick, since nothing is drawn.
class Blind final : public Robot {
 public:
  Blind(const simulator::World& world, const simulator::SimulatorSettings& settings)
      : body_(world, 1, settings, nullptr) {}
  [[nodiscard]] const RobotDescription& description() const override { return body_.description(); }
  [[nodiscard]] const Clock& clock() const override { return body_.clock(); }
  bool sense(Senses& senses) override {
    if (senses_left == 0) return false;
    if (senses_left == 1 && throws) throw std::runtime_error("the cable is out");
    --senses_left;
    return body_.sense(senses);
  }
  void send(const MotorCommand& command) override { body_.send(command); }
  void stop() noexcept override { body_.stop(); }

  simulator::SimulatedPioneer body_;
  int senses_left = 1000;
  bool throws = false;
};

struct Case {
  std::string task = "do:\n  - stop: {}\n";
  bool judged = true;
  double time_limit_s = 600.0;
  double start_m = 1.0;
  double start_left_m = 0.0;
  int senses = 1000;
  bool throws = false;
  bool ctrl_c = false;
};

RunResult came_out(const Case& one) {
  const TemporaryFolder folder;
  MissionOptions options;
  options.task = folder.write("t.yaml", "striate: 1\n" + one.task);
  const BodySource body{.wake = [&](RobotSettings& settings) -> Body {
    simulator::World world = simulator::load_world(STRIATE_SOURCE_DIR "/config/worlds/short.yaml");
    world.start = {one.start_m, one.start_left_m, 0.0};
    settings.simulator.judge.ends_at_goal = false;
    settings.simulator.judge.time_limit_s = one.time_limit_s;
    auto robot = std::make_unique<Blind>(world, settings.simulator);
    robot->senses_left = one.senses;
    robot->throws = one.throws;
    const simulator::Judge* judge = one.judged ? &robot->body_.judge() : nullptr;
    return {.robot = std::move(robot), .place = "short", .judge = judge};
  }};
  Mission mission(options, body);
  return mission.run([&](const Mission&) { return one.ctrl_c; });
}

const Case kWaits{.task = "do:\n  - wait: 60 s\n"};
const Case kFails{.task = "always:\n  - fail_if: {after: 0.2 s}\ndo:\n  - wait: 60 s\n"};

Case with(Case one, const std::function<void(Case&)>& change) {
  change(one);
  return one;
}

std::map<std::string, Case> cases() {
  const auto unjudged = [](Case& one) { one.judged = false; };
  return {
      {"its steps succeed", {}},
      {"its steps succeed, nobody judges", with({}, unjudged)},
      {"its steps succeed and nobody sees the line",
       with({.task = "goal: line\ndo:\n  - stop: {}\n"}, unjudged)},
      {"it stands beyond the line", {.task = "goal: line\ndo:\n  - wait: 60 s\n", .start_m = 12.5}},
      {"its steps end before the line", {.task = "goal: line\ndo:\n  - stop: {}\n"}},
      {"it touches", with(kWaits, [](Case& one) { one.start_left_m = 1.2; })},
      {"a guard fails", kFails},
      {"a guard fails, nobody judges", with(kFails, unjudged)},
      {"time is up", with(kWaits, [](Case& one) { one.time_limit_s = 1.0; })},
      {"the senses end", with(kWaits,
                              [](Case& one) {
                                one.senses = 5;
                                one.judged = false;
                              })},
      {"Ctrl-C", with(kWaits, [](Case& one) { one.ctrl_c = true; })},
      {"the body throws", with(kWaits,
                               [](Case& one) {
                                 one.senses = 5;
                                 one.throws = true;
                               })},
  };
}

TEST(MissionOutcome, IsOneOfTheTableInEveryCaseAndEveryOneOfTheTableIsReached) {
  const std::map<std::string, RunOutcome> expected = {
      {"its steps succeed", RunOutcome::success},
      {"its steps succeed, nobody judges", RunOutcome::success},
      {"its steps succeed and nobody sees the line", RunOutcome::success},
      {"it stands beyond the line", RunOutcome::success},
      {"its steps end before the line", RunOutcome::task_ended},
      {"it touches", RunOutcome::collision},
      {"a guard fails", RunOutcome::task_failed},
      {"a guard fails, nobody judges", RunOutcome::task_failed},
      {"time is up", RunOutcome::time_over},
      {"the senses end", RunOutcome::body_ended},
      {"Ctrl-C", RunOutcome::interrupted},
      {"the body throws", RunOutcome::lost},
  };
  std::map<RunOutcome, int> reached;
  for (const auto& [name, one] : cases()) {
    const RunResult result = came_out(one);
    EXPECT_EQ(name_of(result.outcome), name_of(expected.at(name))) << name << ": " << result.reason;
    EXPECT_EQ(result.reason.empty(), result.outcome == RunOutcome::success) << name;
    ++reached[result.outcome];
  }
  for (const OutcomeRow& row : all_outcomes()) EXPECT_GT(reached[row.outcome], 0) << row.name;
}

TEST(MissionOutcome, JsonHoldsWhatOnlyAJudgeKnowsWhereThereIsOne) {
  const auto judged = to_json(came_out({}));
  const auto alone = to_json(came_out(with({}, [](Case& one) { one.judged = false; })));
  for (const char* key : {"collisions", "nearest_pass_m", "seed"}) {
    EXPECT_TRUE(judged.contains(key)) << key;
    EXPECT_FALSE(alone.contains(key)) << key;
  }
  for (const char* key : {"outcome", "reason", "reached_goal", "distance_m", "duration_s", "cycles",
                          "task", "world", "emergency_layer", "emergency_stops"}) {
    EXPECT_TRUE(judged.contains(key)) << key;
    EXPECT_TRUE(alone.contains(key)) << key;
  }
}

TEST(MissionOutcome, AnyOfTheTableIsReadFromJsonAgainAndNoOther) {
  for (const OutcomeRow& row : all_outcomes()) {
    RunResult result;
    result.outcome = row.outcome;
    nlohmann::json json = to_json(result);
    EXPECT_EQ(run_result_from_json(json).outcome, row.outcome) << row.name;
    json["outcome"] = std::string(row.name) + "s";
    EXPECT_THROW((void)run_result_from_json(json), std::runtime_error) << row.name;
  }
}

}  // namespace
}  // namespace striate::agent
