#include "striate/app/reports.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <new>
#include <stdexcept>

namespace striate::app {
namespace {

TEST(ReportsOfAMission, WhatFailedIsLeftOutFromThenOnAndSaidOnce) {
  Reports reports;
  int tried = 0;
  int others = 0;
  for (int cycle = 0; cycle < 3; ++cycle) {
    reports.attempt("the pictures", [&] {
      ++tried;
      throw std::runtime_error("the disk is full");
    });
    reports.attempt("the memory", [&] { ++others; });
  }
  EXPECT_EQ(tried, 1);
  EXPECT_EQ(others, 3);
  EXPECT_TRUE(reports.any_failed());
  EXPECT_EQ(reports.text(), "the pictures: the disk is full\n");
}

TEST(ReportsOfAMission, WhateverIsThrownIsHeld) {
  Reports reports;
  reports.attempt("one", [] { throw 7; });
  reports.attempt("two", [] { throw std::bad_alloc(); });
  EXPECT_THAT(reports.text(), testing::HasSubstr("one: an unknown error\n"));
  EXPECT_THAT(reports.text(), testing::HasSubstr("two: "));
}

TEST(ReportsOfAMission, AreClosedThoughTheyHaveFailed) {
  Reports reports;
  reports.note("the recording", "too slow");
  bool closed = false;
  reports.finish("the recording", [&] { closed = true; });
  EXPECT_TRUE(closed);
  reports.note("the result", "");
  EXPECT_EQ(reports.text(), "the recording: too slow\n");
}

}  // namespace
}  // namespace striate::app
