#include "striate/platform/pioneer/laser/urg_driver.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <deque>

#include "striate/base/geometry.hpp"
#include "striate/platform/pioneer/firmware/urg_device.hpp"
#include "tests/reference/captures.hpp"
#include "tests/unit/pioneer/late_scans.hpp"

namespace striate::pioneer {
namespace {

/// Driver and device on one line, in steps of 10 ms of virtual time.
struct UrgBed {
  void run(double seconds) {
    for (double t = 0.0; t < seconds - 1e-9; t += 0.01) {
      now += std::chrono::milliseconds(10);
      driver.tick(now);
      const Bytes out = driver.take_output();
      if (plugged) device.receive(out);
      device.step(now, std::vector<int>(device.rays(), 2000));
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
  UrgDriver driver{LaserSettings{}};
  UrgDevice device;
  TimePoint now{std::chrono::seconds(5)};
  bool plugged = true;
  bool wrong_bit = false;
  Duration late{};  ///< what the laser says, on its way
  std::deque<std::pair<TimePoint, Bytes>> under_way;
};

TEST(UrgDriver, SetsTheDeviceUpAndSeesTenTimesASecond) {
  UrgBed bed;
  bed.run(1.0);
  const RangeScan scan = bed.driver.scan(bed.now);
  ASSERT_EQ(scan.readings.size(), 682u);
  EXPECT_NEAR(scan.readings[340].bearing_rad, 0.0, 1e-9);
  EXPECT_NEAR(scan.readings[340].distance_m, 2.0 + 0.021, 1e-9) << "from the axle";
  EXPECT_LT(to_seconds(bed.now - scan.stamp), 0.22);
  EXPECT_GT(to_seconds(bed.now - scan.stamp), 0.09) << "the first ray's time";
  EXPECT_EQ(bed.driver.set_ups(), 1u);
  const std::uint64_t before = bed.driver.counters().replies;
  bed.run(1.0);
  EXPECT_NEAR(static_cast<double>(bed.driver.counters().replies - before), 10.0, 1.0);
}

TEST(UrgDriver, AStaleScanIsNone) {
  UrgBed bed;
  bed.run(1.0);
  bed.plugged = false;
  bed.run(0.55);
  EXPECT_FALSE(bed.driver.scanning(bed.now));
}

TEST(UrgDriver, BeginsAgainWhenTheDeviceComesBack) {
  UrgBed bed;
  bed.run(1.0);
  bed.plugged = false;
  bed.run(5.0);
  bed.device.reboot();
  bed.plugged = true;
  bed.run(1.2);
  EXPECT_TRUE(bed.driver.scanning(bed.now));
  EXPECT_GT(bed.driver.set_ups(), 2u);
}

TEST(UrgDriver, AScanThatWasLongUnderWayIsOld) {
  expect_a_delay_that_begins_is_found<UrgBed>();
}

TEST(UrgDriver, ALaserThatIsLateFromTheBeginningIsNotTakenForAFreshOne) {
  expect_a_delay_from_the_beginning_is_found<UrgBed>();
}

TEST(UrgDriver, ScansWithWrongSumsAreNotTaken) {
  UrgBed bed;
  bed.run(1.0);
  bed.wrong_bit = true;
  bed.run(0.6);
  EXPECT_FALSE(bed.driver.scanning(bed.now));
  EXPECT_GT(bed.driver.counters().bad_sum, 3u);
  bed.wrong_bit = false;
  bed.run(2.0);
  EXPECT_TRUE(bed.driver.scanning(bed.now));
}

TEST(UrgDriver, SwitchesTheLaserOffAtTheEnd) {
  UrgBed bed;
  bed.run(1.0);
  bed.driver.close();
  bed.run(2.0);
  EXPECT_FALSE(bed.driver.scanning(bed.now));
  EXPECT_EQ(bed.driver.set_ups(), 1u);
}

TEST(UrgDriver, SetsUpALaserThatWasLeftInClockMode) {
  UrgBed bed;
  bed.device.receive(Bytes{'T', 'M', '0', '\n'});
  (void)bed.device.take_output();
  bed.run(1.0);
  EXPECT_TRUE(bed.driver.scanning(bed.now));
}

TEST(UrgDevice, AnswersTheRecordedClient) {
  for (const auto& file : reference::urg_captures()) {
    SCOPED_TRACE(file);
    UrgDevice device;
    scip::ReplyStream stream;
    TimePoint now;
    for (const auto& chunk : reference::read_capture(file)) {
      if (chunk.direction == "H>L") device.receive(chunk.bytes);
      stream.push(device.take_output());
    }
    for (int i = 0; i < 100; ++i) {
      now += std::chrono::milliseconds(10);
      device.step(now, std::vector<int>(device.rays(), 1500));
    }
    stream.push(device.take_output());
    int scans = 0, refused = 0;
    while (const auto reply = stream.next()) {
      if (reply->status == "0E") ++refused;
      const auto scan = scip::read_scan(*reply, device.parameters());
      if (!scan) continue;
      EXPECT_EQ(scan->rays.size(), 228u);
      ++scans;
    }
    EXPECT_EQ(refused, 0);
    EXPECT_NEAR(scans, 10, 1);
    EXPECT_EQ(stream.counters().bad_sum, 0u);
  }
}

}  // namespace
}  // namespace striate::pioneer
