#pragma once

#include <gtest/gtest.h>

#include "striate/base/time.hpp"
#include "striate/platform/interface/senses.hpp"

/// What every laser's driver owes when its line is late. `Bed` is driver, device and line:
/// `run(s)`, `driver`, `now`, and `late`, the delay of what the laser says.
namespace striate::pioneer {

/// Runs 10 ms at a time and asks the age of every scan. @return how many scans there were
template <class Bed>
int expect_scans_as_old_as_the_line(Bed& bed, double seconds, TimePoint from) {
  int scans = 0;
  const TimePoint end = bed.now + from_seconds(seconds);
  while (bed.now < end) {
    bed.run(0.01);
    const RangeScan scan = bed.driver.scan(bed.now);
    if (scan.readings.empty() || bed.now < from) continue;
    ++scans;
    EXPECT_GE(bed.now - scan.stamp, bed.late) << to_seconds(bed.late);
    if (testing::Test::HasFailure()) break;
  }
  return scans;
}

template <class Bed>
void expect_a_delay_that_begins_is_found() {
  using namespace std::chrono_literals;
  for (const Duration late : {Duration(300ms), Duration(800ms), Duration(3s)}) {
    Bed bed;
    bed.run(1.0);
    ASSERT_TRUE(bed.driver.scanning(bed.now));
    bed.late = late;
    (void)expect_scans_as_old_as_the_line(bed, 15.0, bed.now + late);
    EXPECT_EQ(bed.driver.scanning(bed.now), late < 500ms);
  }
}

template <class Bed>
void expect_a_delay_from_the_beginning_is_found() {
  using namespace std::chrono_literals;
  for (Duration late = 260ms; late < 3200ms; late += 70ms) {
    Bed bed;
    bed.late = late;
    const int scans = expect_scans_as_old_as_the_line(bed, 20.0, bed.now);
    if (late < 300ms) {
      EXPECT_GT(scans, 100) << "a scan of 0.26 s is still seen";
    }
  }
}

}  // namespace striate::pioneer
