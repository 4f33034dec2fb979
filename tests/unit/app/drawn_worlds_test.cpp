#include "striate/app/trial/drawn_worlds.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "striate/agent/run_result.hpp"
#include "striate/app/trial/trial_merge.hpp"
#include "striate/app/trial/trial_table.hpp"
#include "striate/base/files.hpp"
#include "striate/base/user_error.hpp"
#include "striate/platform/simulator/world_reader.hpp"

namespace striate::app {
namespace {

TrialOptions drawn_trial(const std::string& folder, const std::string& seeds,
                         const std::string& kind = "") {
  TrialOptions options;
  options.out = folder;
  options.runs = 1;
  draw_trial_worlds({seeds, kind}, options);
  return options;
}

TEST(DrawnWorlds, LieBesideTheResultsAndAreDrivenWithTheirOwnSeeds) {
  const ScratchFolder folder;
  const TrialOptions options = drawn_trial(folder.path(), "5..9");
  const std::vector<TrialRun> runs = plan_trial(options);
  ASSERT_EQ(runs.size(), 5U);
  EXPECT_EQ(runs[0].world, folder.path() + "/worlds/office_0005.yaml");
  EXPECT_EQ(runs[1].world, folder.path() + "/worlds/hospital_0006.yaml");
  for (std::size_t i = 0; i < runs.size(); ++i) {
    EXPECT_EQ(runs[i].seed, 5 + i);
    EXPECT_EQ(simulator::load_world(runs[i].world).name, world_name(runs[i].world));
  }
}

TEST(DrawnWorlds, AreTheSameWhenATrialGoesOnAndOthersAreRefused) {
  const ScratchFolder folder;
  (void)drawn_trial(folder.path(), "3", "school");
  (void)drawn_trial(folder.path(), "3", "school");
  write_file(folder.path() + "/worlds/school_0003.yaml", "striate_world: 1\n");
  EXPECT_THROW((void)drawn_trial(folder.path(), "3", "school"), UserError);
}

TEST(DrawnWorlds, ThatAreNoSeedsAreRefused) {
  const ScratchFolder folder;
  for (const char* seeds : {"", "..", "1..", "..7", "9..3", "a..b", "1..2..3", "-1..4", "1...3",
                            "0..18446744073709551615"}) {
    EXPECT_THROW((void)drawn_trial(folder.path(), seeds), UserError) << seeds;
  }
}

agent::RunResult drawn_run(const std::string& name, std::uint64_t seed) {
  agent::RunResult result;
  result.world = "out/worlds/" + name + ".yaml";
  result.task = "t.yaml";
  result.seed = seed;
  result.outcome = agent::RunOutcome::success;
  return result;
}

TEST(TrialTable, OfDrawnBuildingsHasARowForEachKind) {
  const std::string table = trial_table({drawn_run("office_0005", 5), drawn_run("office_0010", 10),
                                         drawn_run("school_0008", 8), drawn_run("office_7", 7)});
  EXPECT_THAT(table, testing::HasSubstr("| office, drawn | 2 / 2 |"));
  EXPECT_THAT(table, testing::HasSubstr("| school, drawn | 1 / 1 |"));
  EXPECT_THAT(table, testing::HasSubstr("| office_7 | 1 / 1 |")) << "somebody's own";
}

TEST(TrialMerge, MissesNothingOfDrawnBuildingsWhichAreDrivenWithOneSeedEach) {
  const ScratchFolder folder;
  for (const auto& [name, seed] :
       {std::pair{"office_0005", 5}, {"hospital_0006", 6}, {"basement_0007", 7}}) {
    write_file(folder.path() + "/1/runs/" + name + ".json",
               agent::to_json(drawn_run(name, static_cast<std::uint64_t>(seed))).dump());
  }
  testing::internal::CaptureStdout();
  EXPECT_EQ(merge_trials({folder.path() + "/1"}, folder.path()), 0);
  EXPECT_THAT(testing::internal::GetCapturedStdout(), testing::HasSubstr("| all | 3 / 3 |"));
}

}  // namespace
}  // namespace striate::app
