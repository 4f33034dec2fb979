#include <gtest/gtest.h>

#include "striate/base/counted.hpp"
#include "striate/base/median.hpp"

namespace striate {
namespace {

TEST(Counted, OneThingIsSingular) {
  EXPECT_EQ(counted(0, "view"), "0 views");
  EXPECT_EQ(counted(1, "view"), "1 view");
  EXPECT_EQ(counted(2, "view"), "2 views");
}

TEST(Median, IsTheMiddleOneAndOfAnEvenNumberTheLarger) {
  EXPECT_EQ(median_of({}), 0.0);
  EXPECT_EQ(median_of({3.0}), 3.0);
  EXPECT_EQ(median_of({9.0, 1.0, 5.0}), 5.0);
  EXPECT_EQ(median_of({9.0, 1.0, 5.0, 4.0}), 5.0);
}

}  // namespace
}  // namespace striate
