#include "striate/agent/mission.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/scenarios/short_world.hpp"
#include "tests/scenarios/striate_process.hpp"

namespace striate::scenarios {
namespace {

nlohmann::json without_wall_clock(const std::string& file) {
  nlohmann::json json = nlohmann::json::parse(read_text(file));
  json.erase("mean_cycle_ms");
  json.erase("realtime_factor");
  return json;
}

TEST(ShortMission, ReachesTheGoalByVisionAloneAndWritesItsImages) {
  const TemporaryFolder folder;
  const Ended ended =
      striate({"run", "config/tasks/corridor.yaml", "--world", "config/worlds/short.yaml", "--seed",
               "3", "--no-emergency", "--result", folder / "r.json", "--picture-every", "40",
               "--pictures", folder / "p"});
  EXPECT_EQ(ended.exit_code, 0) << ended.err << ended.out;
  const auto result = nlohmann::json::parse(read_text(folder / "r.json"));
  EXPECT_EQ(result.at("outcome"), "success");
  EXPECT_TRUE(result.at("reached_goal"));
  EXPECT_TRUE(result.at("collisions").empty());
  EXPECT_GT(result.at("distance_m"), 8.0);
  EXPECT_GT(result.at("nearest_pass_m"), 0.0);
  EXPECT_FALSE(result.at("emergency_layer"));
  EXPECT_TRUE(std::filesystem::exists(folder / "p/plan.png"));
  EXPECT_TRUE(std::filesystem::exists(folder / "p/overview_00040.png"));
}

Ended short_trial(const TemporaryFolder& folder, const std::vector<std::string>& more) {
  const std::string task = folder.write(
      "some_way.yaml",
      "striate: 1\ndo:\n  - traverse_corridor: {speed: 0.6 m/s}\n    until: {progress: 2.5 m}\n");
  std::vector<std::string> words{
      "trial", "--task", task, "--worlds", "config/worlds/short.yaml", "--runs", "2", "--quiet"};
  words.insert(words.end(), more.begin(), more.end());
  return striate(words);
}

TEST(ShortMission, TheSameSeedTwiceGivesTheSameResultAlsoInATrialOfTwoJobs) {
  const TemporaryFolder folder;
  for (const char* name : {"a", "b"}) {
    const Ended ended = short_trial(folder, {"--jobs", "2", "--out", folder / name});
    ASSERT_EQ(ended.exit_code, 0) << ended.err;
  }
  for (const char* seed : {"001", "002"}) {
    const std::string file = std::string("runs/short_seed") + seed + ".json";
    EXPECT_EQ(without_wall_clock(folder / "a/" + file), without_wall_clock(folder / "b/" + file));
  }
  EXPECT_NE(without_wall_clock(folder / "a/runs/short_seed001.json").at("distance_m"),
            without_wall_clock(folder / "a/runs/short_seed002.json").at("distance_m"));

  // A trial that lost a run goes on with that run alone.
  std::filesystem::remove(folder / "a/runs/short_seed002.json");
  const auto kept = std::filesystem::last_write_time(folder / "a/runs/short_seed001.json");
  const Ended resumed = short_trial(folder, {"--out", folder / "a"});
  EXPECT_EQ(resumed.exit_code, 0) << resumed.err;
  EXPECT_EQ(std::filesystem::last_write_time(folder / "a/runs/short_seed001.json"), kept);
  EXPECT_EQ(without_wall_clock(folder / "a/runs/short_seed002.json"),
            without_wall_clock(folder / "b/runs/short_seed002.json"));
  EXPECT_THAT(resumed.out, testing::HasSubstr("| short | "));

  // Results of another kind are not mixed in.
  const Ended other = short_trial(folder, {"--no-emergency", "--out", folder / "a"});
  EXPECT_EQ(other.exit_code, 2);
  EXPECT_THAT(other.err, testing::HasSubstr("another trial"));
}

TEST(ShortMission, CtrlCStopsTheRobotAndStillWritesTheResult) {
  const TemporaryFolder folder;
  const Ended ended =
      striate({"run", "config/tasks/corridor.yaml", "--world", "config/worlds/corridor_a.yaml",
               "--result", folder / "r.json", "--quiet", "--inspect", folder / "now.json"},
              {.after = std::chrono::milliseconds(1000), .once_there_is = folder / "now.json"});
  EXPECT_EQ(ended.exit_code, 130) << ended.err;
  const auto result = nlohmann::json::parse(read_text(folder / "r.json"));
  EXPECT_EQ(result.at("outcome"), "interrupted");
}

TEST(ShortMission, AnInterruptionBringsTheWheelsToAStandBeforeTheEnd) {
  agent::Mission mission(shipped_task("corridor.yaml"), in_short_world());
  bool drove = false;
  const agent::RunResult result = mission.run([&](const agent::Mission& running) {
    drove = drove || running.cycle().trace().senses.odometry.forward_m_s > 0.2;
    return drove;
  });
  EXPECT_TRUE(drove);
  EXPECT_EQ(result.outcome, agent::RunOutcome::interrupted);
  EXPECT_EQ(mission.cycle().trace().sent.forward_m_s, 0.0);
  EXPECT_EQ(mission.cycle().trace().sent.turn_rad_s, 0.0);
}

TEST(CameraFault, NoImageForHalfASecondMeansStopAndNothingMovesUntilItSeesAgain) {
  const TemporaryFolder folder;
  agent::MissionOptions options = shipped_task("corridor.yaml");
  options.robot = folder.write(
      "r.yaml", "simulator: {faults: {camera_stops_at: 6 s, camera_returns_at: 10 s}}\n");
  agent::Mission mission(options, in_short_world());
  bool drove_before = false;
  bool drove_after = false;
  double worst_age_driving_s = 0.0;
  mission.run([&](const agent::Mission& running) {
    const agent::CycleTrace& trace = running.cycle().trace();
    const double now_s = to_seconds(trace.senses.now);
    const double age_s = to_seconds(trace.senses.now - trace.senses.stereo.stamp);
    const bool commands_motion =
        std::abs(trace.sent.forward_m_s) > 0.0 || std::abs(trace.sent.turn_rad_s) > 0.0;
    if (commands_motion) {
      worst_age_driving_s = std::max(worst_age_driving_s, age_s);
      drove_before = drove_before || now_s < 6.0;
      drove_after = drove_after || now_s > 11.0;
    }
    if (now_s > 7.5 && now_s < 10.0) {
      EXPECT_EQ(trace.sent.forward_m_s, 0.0) << now_s;
      EXPECT_NEAR(trace.senses.odometry.forward_m_s, 0.0, 1e-3) << now_s;
    }
    return now_s > 14.0;
  });
  EXPECT_TRUE(drove_before);
  EXPECT_TRUE(drove_after);
  // While it brakes the command still falls from cycle to cycle: 0.5 m/s at 0.5 m/s2.
  EXPECT_LT(worst_age_driving_s, 0.5 + 1.0);
}

}  // namespace
}  // namespace striate::scenarios
