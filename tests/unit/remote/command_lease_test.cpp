#include "striate/platform/remote/command_lease.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace striate::remote {
namespace {

using namespace std::chrono_literals;

TEST(CommandLease, DrivesForHalfASecondAndNoLonger) {
  CommandLease lease(500ms);
  EXPECT_FALSE(lease.at(TimePoint(0ms))) << "nobody has commanded yet";
  MotorCommand command;
  command.forward_m_s = 0.3;
  lease.give(command, TimePoint(1s));
  ASSERT_TRUE(lease.at(TimePoint(1500ms)));
  EXPECT_EQ(lease.at(TimePoint(1500ms))->forward_m_s, 0.3);
  EXPECT_FALSE(lease.at(TimePoint(1501ms)));
}

TEST(CommandLease, ASpeedThatIsNoNumberIsAStop) {
  CommandLease lease(500ms);
  MotorCommand command;
  command.forward_m_s = 0.3;
  command.turn_rad_s = std::numeric_limits<double>::quiet_NaN();
  lease.give(command, TimePoint(1s));
  EXPECT_EQ(lease.at(TimePoint(1s))->forward_m_s, 0.0);
  EXPECT_EQ(lease.at(TimePoint(1s))->turn_rad_s, 0.0);
}

}  // namespace
}  // namespace striate::remote
