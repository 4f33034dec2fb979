#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <set>

#include "striate/agent/run_result.hpp"
#include "striate/app/pose_text.hpp"
#include "striate/app/trial/process_pool.hpp"
#include "striate/app/trial/trial_folder.hpp"
#include "striate/app/trial/trial_merge.hpp"
#include "striate/app/trial/trial_plan.hpp"
#include "striate/app/trial/trial_table.hpp"
#include "striate/base/files.hpp"
#include "striate/base/user_error.hpp"

namespace striate::app {
namespace {

using testing::HasSubstr;

agent::RunResult run(const std::string& world, std::uint64_t seed, bool success) {
  agent::RunResult result;
  result.world = "config/worlds/" + world + ".yaml";
  result.task = "t.yaml";
  result.seed = seed;
  result.outcome = success ? agent::RunOutcome::success : agent::RunOutcome::collision;
  result.distance_m = 57.0;
  result.duration_s = 150.0;
  if (!success) result.collisions.push_back({12.5, 3.25, -0.5, "table_1", 0.1, false});
  return result;
}

TEST(WilsonInterval, AgreesWithPublishedValues) {
  // Newcombe 1998, table I: 81 of 263 gives 0.2553 to 0.3662.
  const Interval interval = wilson_interval(81, 263);
  EXPECT_NEAR(interval.low, 0.2553, 5e-4);
  EXPECT_NEAR(interval.high, 0.3662, 5e-4);
  EXPECT_NEAR(wilson_interval(20, 20).low, 0.8389, 5e-4);
  EXPECT_DOUBLE_EQ(wilson_interval(20, 20).high, 1.0);
}

TEST(TrialTable, CountsSuccessesAndCausesByWorld) {
  const std::string table =
      trial_table({run("corridor_a", 1, true), run("corridor_a", 2, false), run("mine", 1, true)});
  EXPECT_THAT(table, HasSubstr("| corridor_a | 1 / 2 | 50 % |"));
  EXPECT_THAT(table, HasSubstr("| 17 / 20 |"));
  EXPECT_THAT(table, HasSubstr("| mine | 1 / 1 | 100 % |"));
  EXPECT_THAT(table, HasSubstr("| all | 2 / 3 |"));
  EXPECT_THAT(table, HasSubstr("1 x touched table, still, in the dark"));
}

TEST(TrialTable, GivesABaselineRowsOfItsOwn) {
  agent::RunResult other = run("corridor_a", 1, false);
  other.baseline = "sgbm";
  agent::RunResult other_b = run("corridor_b", 1, true);
  other_b.baseline = "sgbm";
  const std::vector<agent::RunResult> all = {run("corridor_a", 1, true), run("corridor_b", 1, true),
                                             other, other_b};
  const std::string table = trial_table(all);
  EXPECT_THAT(table, HasSubstr("| corridor_a | 1 / 1 |"));
  EXPECT_THAT(table, HasSubstr("| corridor_a, sgbm | 0 / 1 |"));
  EXPECT_THAT(table, HasSubstr("| all | 2 / 2 |"));
  EXPECT_THAT(table, HasSubstr("| all, sgbm | 1 / 2 |"));
  EXPECT_THAT(replay_commands(all, ""), HasSubstr("--baseline sgbm"));
}

TEST(TrialTable, SaysWhyARunStoodLong) {
  agent::RunResult stood = run("corridor_a", 2, true);
  stood.longest_stand_s = 31.0;
  stood.longest_stand_why = "waits: something moves ahead";
  EXPECT_THAT(trial_table({run("corridor_a", 1, true), stood}),
              HasSubstr("- corridor_a seed 2, 31 s (waits: something moves ahead)\n"));
  EXPECT_THAT(trial_table({run("corridor_a", 1, true)}), testing::Not(HasSubstr("Stood")));
}

TEST(TrialTable, GivesACommandThatRepeatsEachFailedRun) {
  agent::RunResult failed = run("corridor_a", 2, false);
  failed.emergency_layer = false;
  const std::string text = replay_commands({run("corridor_a", 1, true), failed}, "r.yaml");
  EXPECT_THAT(text, HasSubstr("striate run t.yaml --world config/worlds/corridor_a.yaml --seed 2 "
                              "--no-emergency --robot r.yaml --picture-every 10"));
  EXPECT_THAT(text, testing::Not(HasSubstr("--seed 1")));
  EXPECT_EQ(replay_commands({run("corridor_a", 1, true)}, ""), "");
}

TEST(TrialPlan, ShardsShareAllRunsAndEachHasItsPartOfEveryWorld) {
  TrialOptions options;
  options.worlds = {"a.yaml", "b.yaml"};
  options.runs = 7;
  std::set<std::string> files;
  for (int shard = 1; shard <= 3; ++shard) {
    options.shard = shard;
    options.shards = 3;
    const auto runs = plan_trial(options);
    EXPECT_NEAR(static_cast<double>(runs.size()), 14.0 / 3.0, 1.0);
    for (const TrialRun& one : runs) EXPECT_TRUE(files.insert(one.result_file).second);
  }
  EXPECT_EQ(files.size(), 14U);
}

TEST(TrialMerge, JoinsFoldersAndRefusesWhatDoesNotBelongTogether) {
  const std::string base = testing::TempDir() + "merge_" + std::to_string(getpid());
  const auto put = [&](const std::string& folder, const agent::RunResult& result) {
    write_file(fmt::format("{}/{}/runs/{}.json", base, folder, result.seed),
               agent::to_json(result).dump());
  };
  put("1", run("corridor_a", 1, true));
  put("2", run("corridor_a", 2, false));
  testing::internal::CaptureStdout();
  EXPECT_EQ(merge_trials({base + "/1", base + "/2"}, base + "/all"), 0);
  EXPECT_THAT(testing::internal::GetCapturedStdout(), HasSubstr("| corridor_a | 1 / 2 | 50 % |"));
  EXPECT_TRUE(std::filesystem::exists(base + "/all/runs.csv"));
  agent::RunResult lost = run("corridor_a", 5, false);
  lost.outcome = agent::RunOutcome::lost;
  put("5", lost);
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  EXPECT_EQ(merge_trials({base + "/1", base + "/2", base + "/5"}, base + "/all"), 1);
  (void)testing::internal::GetCapturedStdout();
  EXPECT_THAT(testing::internal::GetCapturedStderr(),
              testing::AllOf(HasSubstr("3 runs are not in the table"), HasSubstr("seed 4")));
  EXPECT_THROW(merge_trials({base + "/nowhere"}, base + "/all"), UserError);
  agent::RunResult other = run("corridor_a", 3, true);
  other.emergency_layer = !other.emergency_layer;
  put("3", other);
  EXPECT_THROW(merge_trials({base + "/1", base + "/3"}, base + "/all"), UserError);
  put("4", run("corridor_a", 2, true));
  EXPECT_THROW(merge_trials({base + "/2", base + "/4"}, base + "/all"), UserError);
  std::filesystem::remove_all(base);
}

TEST(RunResult, JsonRoundTripKeepsEverything) {
  agent::RunResult result = run("corridor_b", 7, false);
  result.reason = "a \"quoted\" reason";
  result.emergency_layer = false;
  result.longest_stand_why = "looks round for a gap";
  result.failure = "way_blocked";
  result.failure_line = 12;
  result.late_obstacles = {{"new_box", 41.5, 6.5}, {"new_chair", std::nullopt, 0.0}};
  const agent::RunResult back =
      agent::run_result_from_json(nlohmann::json::parse(agent::to_json(result).dump()));
  EXPECT_EQ(agent::to_json(back).dump(), agent::to_json(result).dump());
  EXPECT_EQ(back.longest_stand_why, "looks round for a gap");
  EXPECT_EQ(back.failure, "way_blocked");
  EXPECT_EQ(back.failure_line, 12);
  ASSERT_EQ(back.late_obstacles.size(), 2U);
  EXPECT_EQ(late_obstacles_text(back), "new_box after 42 s, new_chair never");
  EXPECT_THAT(trial_table({back}), HasSubstr("never was:\n- corridor_b seed 7: new_chair\n"));
  EXPECT_THROW((void)agent::run_result_from_json(nlohmann::json::parse("{\"outcome\": 3}")),
               std::runtime_error);
}

TEST(WriteFile, AFullDiskIsSaidAndTheOldFileStays) {
  const std::string file = testing::TempDir() + "striate_full_disk.json";
  write_file(file, "old");
  // A limit on file size fails writes as a full disk does, half-way through the content.
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  rlimit tiny = before;
  tiny.rlim_cur = 100;
  auto* const handler = std::signal(SIGXFSZ, SIG_IGN);
  setrlimit(RLIMIT_FSIZE, &tiny);
  std::string said;
  try {
    write_file(file, std::string(100000, 'x'));
  } catch (const std::runtime_error& error) {
    said = error.what();
  }
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  EXPECT_THAT(said, HasSubstr("striate_full_disk.json: cannot be written"));
  EXPECT_FALSE(std::filesystem::exists(file + ".part"));
  std::ifstream stream(file);
  std::string content;
  stream >> content;
  EXPECT_EQ(content, "old");
  std::filesystem::remove(file);
}

TEST(TrialPlan, NamesEveryRunOnce) {
  TrialOptions options;
  options.worlds = {"x/a.yaml", "b.yaml"};
  options.runs = 3;
  options.first_seed = 5;
  options.out = "o";
  options.emergency_layer = false;
  const auto runs = plan_trial(options);
  ASSERT_EQ(runs.size(), 6U);
  EXPECT_EQ(runs[0].result_file, "o/runs/a_seed005.json");
  EXPECT_EQ(runs[5].seed, 7U);
  EXPECT_THAT(command_of(runs[0], options, "striate"), testing::Contains("--no-emergency"));
}

TEST(TrialPlan, EveryRunAndItsRepetitionHaveThePluginsOfTheTrial) {
  TrialOptions options;
  options.plugins = {"a.so", "b.so"};
  const std::vector<std::string> command = command_of({"w.yaml", 1, "r.json"}, options, "striate");
  std::string line;
  for (const std::string& word : command) line += word + " ";
  EXPECT_THAT(line, HasSubstr("--plugin a.so --plugin b.so"));
  EXPECT_THAT(replay_commands({run("corridor_a", 2, false)}, "", "", options.plugins),
              HasSubstr("--plugin a.so --plugin b.so --picture-every"));
  agent::RunResult odd = run("corridor_a", 2, false);
  odd.world = "my worlds/it's.yaml";
  EXPECT_THAT(replay_commands({odd}, "a b.yaml"),
              testing::AllOf(HasSubstr("--world 'my worlds/it'\\''s.yaml' --seed 2"),
                             HasSubstr("--robot 'a b.yaml'")));
}

TEST(ProcessPool, RunsAllAndTellsHowEachEnded) {
  std::vector<int> codes(4, -2);
  std::string said;
  run_processes(
      {{"/bin/sh", "-c", "exit 0"},
       {"/bin/sh", "-c", "echo oops >&2; exit 3"},
       {"/bin/sh", "-c", "kill -9 $$"},
       {"/bin/sh", "-c", "exit 1"}},
      2,
      [&](const ProcessEnd& end) {
        codes[end.job] = end.exit_code;
        if (end.job == 1) said = end.output;
      },
      [] { return false; });
  EXPECT_THAT(codes, testing::ElementsAre(0, 3, -1, 1));
  EXPECT_EQ(said, "oops\n");
}

/// A run whose trial was killed would go on unseen, and beside it the one that is started in its
/// place.
TEST(ProcessPool, WhatItStartedEndsWithItWhateverEndsIt) {
  std::array<int, 2> ends{};
  ASSERT_EQ(pipe(ends.data()), 0);
  const pid_t parent = fork();
  if (parent == 0) {
    close(ends[0]);
    const std::string tell = "echo $$ >&" + std::to_string(ends[1]) + "; exec sleep 60";
    run_processes(
        {{"/bin/sh", "-c", tell}}, 1, [](const ProcessEnd&) {}, [] { return false; });
    _exit(0);
  }
  close(ends[1]);
  std::array<char, 32> said{};
  ASSERT_GT(read(ends[0], said.data(), said.size() - 1), 0);
  kill(parent, SIGKILL);
  waitpid(parent, nullptr, 0);
  // The child holds the other end of the pipe until it ends.
  pollfd closed{ends[0], POLLIN, 0};
  EXPECT_EQ(poll(&closed, 1, 5000), 1) << "it goes on: " << said.data();
  close(ends[0]);
}

TEST(Trial, TwoAtOnceDoNotWriteIntoOneFolder) {
  const std::string out = testing::TempDir() + "one_trial";
  std::filesystem::remove_all(out);
  {
    const TrialFolder one(out);
    try {
      const TrialFolder other(out);
      ADD_FAILURE() << "no error";
    } catch (const UserError& error) {
      EXPECT_THAT(error.what(), HasSubstr("another trial is writing into it"));
    }
  }
  const TrialFolder again(out);
  EXPECT_TRUE(std::filesystem::is_directory(out + "/runs"));
}

TEST(ProcessPool, CancellingEndsTheRunningAndStartsNoMore) {
  int ends = 0;
  run_processes(
      {{"/bin/sleep", "60"}, {"/bin/sleep", "60"}, {"/bin/sleep", "60"}}, 2,
      [&](const ProcessEnd&) { ++ends; }, [calls = 0]() mutable { return ++calls > 2; });
  EXPECT_EQ(ends, 2);
}

TEST(PoseText, ReadsPlacesAndRefusesOthers) {
  const Pose2 place = parse_pose("12 m, 20 cm, 5 deg");
  EXPECT_DOUBLE_EQ(place.x_m, 12.0);
  EXPECT_DOUBLE_EQ(place.y_m, 0.2);
  EXPECT_NEAR(degrees(place.heading_rad), 5.0, 1e-9);
  EXPECT_DOUBLE_EQ(parse_pose("1 m, -0.5 m").y_m, -0.5);
  for (const char* text :
       {"", "12", "12 m", "12 m, 3", "1 m, 2 m, 3 m", "1 m, 2 m, 3 deg, 4", "]"}) {
    EXPECT_THROW((void)parse_pose(text), UserError) << text;
  }
}

}  // namespace
}  // namespace striate::app
