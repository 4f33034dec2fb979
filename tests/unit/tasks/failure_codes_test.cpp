#include <gtest/gtest.h>

#include <set>
#include <string>

#include "striate/behaviours/control/failure.hpp"
#include "striate/tasks/executive.hpp"
#include "striate/tasks/task_reader.hpp"

namespace striate::tasks {
namespace {

using behaviours::Failure;

/// What failed of a script that a robot runs which stands in the dark and knows nothing.
Reason failure_of(const std::string& script) {
  config::Diagnostics diagnostics("t.yaml", 'T');
  Executive executive(read_task("striate: 1\n" + script, diagnostics, RobotDescription{}));
  EXPECT_TRUE(diagnostics.none()) << diagnostics.text();
  const memory::ShortTermMemory memory{memory::ShortTermMemorySettings{}, RobotDescription{}};
  TimePoint now{};
  for (int i = 0; i < 100 && !executive.ended(); ++i) {
    now += std::chrono::milliseconds(100);
    (void)executive.tick(memory, now);
  }
  EXPECT_EQ(executive.state(), MissionState::failed);
  return executive.newest_failure();
}

TEST(FailureCodes, TellWhatFailedAndInWhichLine) {
  const Reason unknown = failure_of(
      "do:\n  - look_at: {pan: 40 deg}\n    within: 1 s\n    optional: true\n  - go_to: book\n");
  EXPECT_EQ(unknown.failure(), Failure::not_known);
  EXPECT_EQ(unknown.line(), 6);

  const Reason late = failure_of("do:\n  - look_at: {pan: 40 deg}\n    within: 1 s\n");
  EXPECT_EQ(late.failure(), Failure::took_too_long);
  EXPECT_EQ(late.line(), 3);

  const Reason guarded = failure_of(
      "always:\n  - fail_if: {image_older_than: 1 s}\ndo:\n  - look_at: {pan: 40 deg}\n");
  EXPECT_EQ(guarded.failure(), Failure::guard);
  EXPECT_EQ(guarded.line(), 3);
}

TEST(FailureCodes, OfAFallbackIsThatOfItsLast) {
  const Reason last = failure_of(
      "do:\n  - try:\n      - look_at: {pan: 40 deg}\n        within: 1 s\n      - go_to: book\n");
  EXPECT_EQ(last.failure(), Failure::not_known);
  EXPECT_EQ(last.line(), 6);
}

TEST(FailureCodes, HaveOneNameEach) {
  std::set<std::string_view> names;
  for (const behaviours::FailureRow& row : behaviours::all_failures()) {
    EXPECT_EQ(behaviours::name_of(row.failure), row.name);
    EXPECT_FALSE(row.meaning.empty());
    names.insert(row.name);
  }
  EXPECT_EQ(names.size(), behaviours::all_failures().size());
}

}  // namespace
}  // namespace striate::tasks
