#include "striate/base/index_within.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace striate {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
const double kNone = std::nan("");

TEST(IndexWithin, IsThePlainConversionWherePlainConversionsAreDefined) {
  for (double value = -12.0; value <= 12.0; value += 0.0625) {
    EXPECT_EQ(cut_within(value, -99, 99), static_cast<int>(value)) << value;
    EXPECT_EQ(floor_within(value, -99, 99), static_cast<int>(std::floor(value))) << value;
    EXPECT_EQ(ceil_within(value, -99, 99), static_cast<int>(std::ceil(value))) << value;
    EXPECT_EQ(round_within(value, -99, 99), static_cast<int>(std::lround(value))) << value;
    EXPECT_EQ(cell_below(value), static_cast<int>(std::floor(value))) << value;
    EXPECT_EQ(nearest_cell(value), static_cast<int>(std::lround(value))) << value;
  }
  EXPECT_EQ(round_within(0.49999999999999994, -9, 9), 0);  // whose sum with 0.5 is 1
}

TEST(IndexWithin, StaysWithinBothEndsWhateverComes) {
  for (const auto whole : {cut_within, floor_within, ceil_within, round_within}) {
    EXPECT_EQ(whole(4.0, 0, 4), 4);
    EXPECT_EQ(whole(0.0, 0, 4), 0);
    for (const double high : {5.0, 1e10, 1e300, kInfinity}) EXPECT_EQ(whole(high, 0, 4), 4);
    for (const double low : {-1.0, -1e10, -1e300, -kInfinity, kNone})
      EXPECT_EQ(whole(low, 0, 4), 0);
  }
  EXPECT_EQ(round_within(4.4, 0, 4), 4);
  EXPECT_EQ(floor_within(-0.5, 0, 4), 0);
  EXPECT_EQ(cut_within(2147483646.9, 0, std::numeric_limits<int>::max()), 2147483646);
  EXPECT_EQ(cut_within(2147483648.0, 0, std::numeric_limits<int>::max()),
            std::numeric_limits<int>::max());
}

TEST(IndexWithin, TheDifferenceOfTwoCellsIsANumber) {
  const long apart = static_cast<long>(cell_below(1e300)) - cell_below(-1e300);
  EXPECT_LT(2 * apart, 1L << 32);
  EXPECT_GT(cell_below(1e300), 0);
  EXPECT_LE(cell_below(kNone), 0);
}

}  // namespace
}  // namespace striate
