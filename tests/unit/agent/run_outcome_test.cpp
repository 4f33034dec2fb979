#include "striate/agent/run_outcome.hpp"

#include <gtest/gtest.h>

#include <set>

namespace striate::agent {
namespace {

TEST(RunOutcome, EachStandsInTheTableAtItsPlaceUnderANameOfItsOwn) {
  std::set<std::string_view> names;
  std::size_t place = 0;
  for (const OutcomeRow& row : all_outcomes()) {
    EXPECT_EQ(static_cast<std::size_t>(row.outcome), place++) << row.name;
    EXPECT_EQ(&row_of(row.outcome), &row);
    EXPECT_EQ(outcome_named(row.name), row.outcome);
    EXPECT_TRUE(names.insert(row.name).second) << row.name;
    EXPECT_FALSE(row.meaning.empty()) << row.name;
  }
  EXPECT_EQ(place, static_cast<std::size_t>(RunOutcome::lost) + 1);
}

TEST(RunOutcome, HasTheNamesThatResultsOnTheDiskAreReadBy) {
  for (const char* name : {"success", "collision", "task_failed", "task_ended", "time_over",
                           "interrupted", "lost", "body_ended"}) {
    EXPECT_TRUE(outcome_named(name).has_value()) << name;
  }
  EXPECT_FALSE(outcome_named("").has_value());
  EXPECT_FALSE(outcome_named("Success").has_value());
}

TEST(RunOutcome, OnlySuccessEndsWithZeroAndOnlyAnInterruptionWith130) {
  for (const OutcomeRow& row : all_outcomes()) {
    EXPECT_EQ(row.exit_code == 0, row.outcome == RunOutcome::success) << row.name;
    EXPECT_EQ(row.exit_code == 130, row.outcome == RunOutcome::interrupted) << row.name;
  }
}

TEST(RunOutcome, ATrialMakesARunAgainThatWasInterruptedOrLost) {
  for (const OutcomeRow& row : all_outcomes()) {
    const bool again = row.outcome == RunOutcome::interrupted || row.outcome == RunOutcome::lost;
    EXPECT_EQ(row.finished, !again) << row.name;
  }
}

}  // namespace
}  // namespace striate::agent
