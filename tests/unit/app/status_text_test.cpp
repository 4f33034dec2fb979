#include <gtest/gtest.h>

#include "striate/app/commands/run_report.hpp"

namespace striate::app {
namespace {

const std::vector<StatusPart> kParts = {{2, "12.0 s  "},          {1, "5.0 m  "},
                                        {3, "0.50 m/s  "},        {5, "6.9 ms a cycle  "},
                                        {6, "4.5 x real time  "}, {0, "drives: to the gap"}};

TEST(StatusText, ShowsAllWhereThereIsRoom) {
  EXPECT_EQ(fitting(kParts, 100),
            "12.0 s  5.0 m  0.50 m/s  6.9 ms a cycle  4.5 x real time  drives: to the gap");
}

/// Cut off at its end, it would lose just what the robot does.
TEST(StatusText, OnANarrowTerminalWhatTheRobotDoesStaysToTheLast) {
  EXPECT_EQ(fitting(kParts, 50), "12.0 s  5.0 m  0.50 m/s  drives: to the gap");
  EXPECT_EQ(fitting(kParts, 30), "5.0 m  drives: to the gap");
  EXPECT_EQ(fitting(kParts, 10), "drives: to the gap");
}

}  // namespace
}  // namespace striate::app
