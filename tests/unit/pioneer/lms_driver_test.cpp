#include "striate/platform/pioneer/laser/lms_driver.hpp"

#include <gtest/gtest.h>

#include <deque>

#include "striate/platform/pioneer/firmware/lms_device.hpp"
#include "tests/reference/captures.hpp"
#include "tests/unit/pioneer/late_scans.hpp"

namespace striate::pioneer {
namespace {

/// Driver and device on one line, in steps of 10 ms of virtual time.
struct Bed {
  void run(double seconds) {
    for (double t = 0.0; t < seconds - 1e-9; t += 0.01) {
      now += std::chrono::milliseconds(10);
      driver.tick(now);
      const Bytes out = driver.take_output();
      if (plugged) device.receive(out);
      device.step(now, std::vector<double>(181, 3.0));
      Bytes in = device.take_output();
      if (!plugged) in.clear();
      if (wrong_bit && !in.empty()) in[in.size() / 2] ^= 1;
      under_way.emplace_back(now + late, in);
      while (!under_way.empty() && under_way.front().first <= now) {
        driver.receive(under_way.front().second, now);
        under_way.pop_front();
      }
    }
  }
  LmsDriver driver{LaserSettings{}};
  LmsDevice device;
  TimePoint now{std::chrono::seconds(5)};
  bool plugged = true;
  bool wrong_bit = false;
  Duration late{};  ///< what the laser says, on its way
  std::deque<std::pair<TimePoint, Bytes>> under_way;
};

TEST(LmsDriver, SetsTheLaserUpAndSeesTenTimesASecond) {
  Bed bed;
  bed.run(1.0);
  const RangeScan scan = bed.driver.scan(bed.now);
  ASSERT_EQ(scan.readings.size(), 181u);
  EXPECT_NEAR(scan.readings[90].bearing_rad, 0.0, 1e-9);
  EXPECT_NEAR(scan.readings[90].distance_m, 3.021, 1e-9) << "from the axle";
  EXPECT_LT(scan.readings[0].bearing_rad, -1.5) << "from right to left";
  EXPECT_EQ(bed.driver.set_ups(), 1u);
  EXPECT_GE(bed.driver.counters().acknowledged, 4u);
}

TEST(LmsDriver, AStaleScanIsNoneAndTheLaserIsSetUpAgainWhenItComesBack) {
  Bed bed;
  bed.run(1.0);
  bed.plugged = false;
  bed.run(0.6);
  EXPECT_FALSE(bed.driver.scanning(bed.now));
  bed.run(5.0);
  bed.device.reboot();
  bed.plugged = true;
  bed.run(1.2);
  EXPECT_TRUE(bed.driver.scanning(bed.now));
}

TEST(LmsDriver, AScanThatWasLongUnderWayIsOld) {
  expect_a_delay_that_begins_is_found<Bed>();
}

TEST(LmsDriver, ALaserThatIsLateFromTheBeginningIsNotTakenForAFreshOne) {
  expect_a_delay_from_the_beginning_is_found<Bed>();
}

TEST(LmsDriver, ScansWithAWrongCrcAreNotTaken) {
  Bed bed;
  bed.run(1.0);
  bed.wrong_bit = true;
  bed.run(0.7);
  EXPECT_FALSE(bed.driver.scanning(bed.now));
  EXPECT_GT(bed.driver.counters().bad_crc, 3u);
  bed.wrong_bit = false;
  bed.run(2.5);
  EXPECT_TRUE(bed.driver.scanning(bed.now));
}

TEST(LmsDevice, AnswersTheRecordedClient) {
  for (const auto& file : reference::lms_captures()) {
    SCOPED_TRACE(file);
    LmsDevice device;
    for (const auto& chunk : reference::read_capture(file)) {
      if (chunk.direction == "H>L") device.receive(chunk.bytes);
    }
    lms200::TelegramStream stream;
    stream.push(device.take_output());
    std::vector<int> kinds;
    while (const auto telegram = stream.next()) kinds.push_back(telegram->data[0]);
    EXPECT_EQ(kinds, (std::vector<int>{0x91, 0xbb, 0xa0, 0xf7, 0xa0}));
    EXPECT_EQ(stream.counters().acknowledged, 5u);
  }
}

}  // namespace
}  // namespace striate::pioneer
