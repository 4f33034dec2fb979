#include "striate/platform/remote/gap_watch.hpp"

#include <gtest/gtest.h>

namespace striate::remote {
namespace {

using namespace std::chrono_literals;

MotorCommand forward(double m_s) {
  MotorCommand command;
  command.forward_m_s = m_s;
  return command;
}

TEST(GapWatch, AProgramThatDidNotRunHoldsUntilReset) {
  GapWatch gaps(500ms, 1s);
  TimePoint now(10s);
  for (int i = 0; i < 20; ++i, now += 50ms) {
    gaps.commanded(forward(0.3), now);
    EXPECT_FALSE(gaps.holds());
  }
  now += 30s;
  gaps.look(now);
  EXPECT_TRUE(gaps.holds());
  gaps.commanded(forward(0.3), now + 50ms);
  EXPECT_TRUE(gaps.holds()) << "a new command is no reset";
  gaps.reset();
  gaps.commanded(forward(0.3), now + 10s);
  EXPECT_FALSE(gaps.holds());
}

TEST(GapWatch, ACommandSourceThatHangsInTheMidstOfMotionHolds) {
  for (const double m_s : {0.3, 0.0}) {
    GapWatch gaps(500ms, 1s);
    gaps.commanded(forward(m_s), TimePoint(1s));
    for (TimePoint now(1s); now < TimePoint(3s); now += 50ms) gaps.look(now);
    gaps.commanded(forward(0.3), TimePoint(3s));
    EXPECT_EQ(gaps.holds(), m_s != 0.0) << "one that stood may pause";
  }
}

}  // namespace
}  // namespace striate::remote
