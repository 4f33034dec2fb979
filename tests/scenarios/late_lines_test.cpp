#include "tests/reference/late_lines.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

/// Delays and stops, end to end: a mission of the command over real drivers.
namespace striate::scenarios {
namespace {

using reference::kLateLines;
using reference::LateLine;
using reference::LateMission;

/// Images in real time: a sanitizer's program is too slow for them.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kSanitized = true;
#else
constexpr bool kSanitized = false;
#endif

constexpr double kStartsWithin_s = 25.0;
/// It gathers speed, and a loaded machine slows it by old images.
constexpr double kDrives_m_s = 0.2;

class LateLines : public testing::Test {
 protected:
  void SetUp() override {
    if (kSanitized) GTEST_SKIP() << "under a sanitizer";
  }
  /// A mission that drives.
  void start() {
    mission_.start();
    ASSERT_TRUE(mission_.drives(kDrives_m_s, kStartsWithin_s)) << mission_.said();
  }
  LateMission mission_{STRIATE_BINARY, STRIATE_SOURCE_DIR};
};

class ALateLine : public LateLines,
                  public testing::WithParamInterface<std::pair<LateLine, double>> {};

TEST_P(ALateLine, MakesTheRobotStandAndItTouchesNothing) {
  const auto [line, late_s] = GetParam();
  SCOPED_TRACE(testing::Message() << kLateLines[static_cast<std::size_t>(line)] << " " << late_s);
  start();
  mission_.late(line, late_s);
  const LateMission::Watched seen = mission_.watch(2.5 + late_s + 2.0);
  RecordProperty("seconds", std::to_string(seen.last_moved_s));
  // To notice, to brake, and for the stop to arrive.
  const bool stop_is_late = line == LateLine::to_base || line == LateLine::all;
  EXPECT_LT(seen.last_moved_s, 2.5 + (stop_is_late ? late_s : 0.0));
  EXPECT_FALSE(seen.moves_at_the_end);
  EXPECT_EQ(mission_.state().collisions, 0u);
}

INSTANTIATE_TEST_SUITE_P(
    EachLine, ALateLine,
    testing::Values(std::pair(LateLine::to_base, 0.8), std::pair(LateLine::from_base, 3.0),
                    std::pair(LateLine::camera, 0.8), std::pair(LateLine::camera, 3.0),
                    std::pair(LateLine::laser, 1.5), std::pair(LateLine::turret, 3.0),
                    std::pair(LateLine::all, 0.8)));

TEST_F(LateLines, LinesThatAreLateFromTheBeginningNeverDrive) {
  for (const LateLine line : {LateLine::camera, LateLine::all}) {
    LateMission mission(STRIATE_BINARY, STRIATE_SOURCE_DIR);
    mission.late(line, line == LateLine::all ? 0.8 : 3.0);
    mission.start();
    EXPECT_EQ(mission.watch(8.0).fastest_m_s, 0.0)
        << kLateLines[static_cast<std::size_t>(line)] << "\n"
        << mission.said();
  }
}

TEST_F(LateLines, ABacklogThatIsLetGoAtOnceDoesNotDrive) {
  start();
  mission_.hold(true);
  (void)mission_.watch(3.0);
  ASSERT_EQ(mission_.state().true_forward_m_s, 0.0) << "the watchdog of the robot";
  mission_.hold(false);
  const LateMission::Watched seen = mission_.watch(5.0);
  EXPECT_LT(seen.way_m, 0.02);
  EXPECT_EQ(mission_.state().collisions, 0u);
}

TEST_F(LateLines, AProgramThatWasStoppedHoldsUntilItIsReset) {
  start();
  for (const double stopped_s : {1.0, 3.0}) {
    mission_.program().signal(SIGSTOP);
    (void)mission_.watch(stopped_s);
    mission_.program().signal(SIGCONT);
    const LateMission::Watched seen = mission_.watch(5.0);
    EXPECT_LT(seen.last_moved_s, 1.6) << "it brakes and stands";
    if (stopped_s > 2.5) {
      EXPECT_EQ(seen.fastest_m_s, 0.0) << "it stood and did not start again";
    }
    EXPECT_THAT(mission_.said(), testing::HasSubstr("stands until you let it go on"));
    mission_.program().signal(SIGUSR1);
    EXPECT_TRUE(mission_.drives(kDrives_m_s, 10.0)) << mission_.said();
  }
  EXPECT_EQ(mission_.state().collisions, 0u);
}

}  // namespace
}  // namespace striate::scenarios
