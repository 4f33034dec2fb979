#pragma once

#include <gtest/gtest.h>

#include <string>

#include "tests/unit/pioneer/test_bed.hpp"

/// Whether the robot of a test bed stands, and how long it takes until it is told to.
namespace striate::pioneer {

constexpr double kStep_s = 0.01;

inline bool stands(const TestBed& bed) {
  return bed.firmware.forward_m_s() == 0.0 && bed.firmware.turn_rad_s() == 0.0;
}

/// Seconds until the firmware wants its wheels to stand.
inline double until_commanded(TestBed& bed) {
  const double took_s = bed.run_until([&] { return bed.firmware.commanded_to_stand(); });
  testing::Test::RecordProperty("seconds", std::to_string(took_s));
  return took_s;
}

/// Nothing moves for so long.
inline void expect_still(TestBed& bed, double seconds) {
  bed.run_until([&] { return stands(bed); });
  const TimePoint end = bed.now + from_seconds(seconds);
  while (bed.now < end) {
    bed.step();
    ASSERT_TRUE(stands(bed)) << "moves by itself";
  }
}

}  // namespace striate::pioneer
