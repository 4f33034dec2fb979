#include <gtest/gtest.h>

#include "striate/tasks/executive.hpp"
#include "tests/reference/counted_allocations.hpp"
#include "tests/reference/fifty_nodes.hpp"

namespace striate::tasks {
namespace {

TEST(Ticking, AllocatesNothingAlsoWhenStepsEndFailAndAreHalted) {
  const memory::ShortTermMemory memory({}, {});
  reference::FiftyNodes tree;
  Executive executive(std::move(tree.task));
  TimePoint now{};
  const long before = counted_allocations();
  for (int i = 0; i < 1000; ++i) {
    // The hour of every `within` is over in the middle: all branches are halted and tried again.
    now += i == 500 ? Duration(std::chrono::hours(2)) : Duration(std::chrono::milliseconds(100));
    executive.tick(memory, now);
  }
  EXPECT_EQ(counted_allocations(), before);
  EXPECT_FALSE(executive.ended());
}

}  // namespace
}  // namespace striate::tasks
