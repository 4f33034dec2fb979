#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/scenarios/striate_process.hpp"

namespace striate::scenarios {
namespace {

using testing::HasSubstr;

TEST(LiveTeaching, NeedsATaskAndAWorld) {
  for (const char* option : {"--task", "--world"}) {
    const Ended ended = striate({"teach", "x", option, "config/tasks/teach.yaml", "--yes"});
    EXPECT_EQ(ended.exit_code, 2);
    EXPECT_THAT(ended.err, HasSubstr("needs --task and --world"));
  }
}

TEST(ObjectTrial, ABookThatWasTaughtIsRecognisedInTheOtherWorld) {
  const TemporaryFolder folder;
  const Ended ended =
      striate({"trial", "--objects", "--only", "red_book", "--quiet", "--out", folder / "out"});
  EXPECT_EQ(ended.exit_code, 0) << ended.out << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("red_book"));
  EXPECT_THAT(read_text(folder / "out/objects.csv"), HasSubstr("recognised"));
  EXPECT_EQ(striate({"trial", "--objects", "--only", "spoon", "--out", folder / "out"}).exit_code,
            2);
}

}  // namespace
}  // namespace striate::scenarios
