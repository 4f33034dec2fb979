#include "striate/platform/pioneer/turret/turret_driver.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <deque>
#include <functional>
#include <utility>

#include "striate/platform/pioneer/firmware/servo_bus.hpp"
#include "tests/reference/captures.hpp"
#include "tests/unit/pioneer/test_bed.hpp"

namespace striate::pioneer {
namespace {

/// Driver and servos on one line, in steps of 5 ms of virtual time.
struct Head {
  explicit Head(double pan_rad = 0.8, double tilt_rad = -0.3)
      : bus({ServoModel(1, pan_rad), ServoModel(2, tilt_rad)}) {}

  void step() {
    now += kStep;
    driver.tick(now);
    Bytes out = driver.take_output();
    if (spoil) spoil(out);
    bus.receive(out);
    bus.step(kStep);
    Bytes in = bus.take_output();
    if (spoil) spoil(in);
    driver.receive(in, now);
    fastest_rad_s = std::max({fastest_rad_s, std::abs(bus.servos[0].speed_rad_s()),
                              std::abs(bus.servos[1].speed_rad_s())});
  }
  void run(double seconds) {
    for (double t = 0.0; t < seconds; t += to_seconds(kStep)) step();
  }
  double run_until(const std::function<bool()>& holds) {
    const TimePoint begin = now;
    while (!holds() && now - begin < std::chrono::seconds(10)) step();
    return to_seconds(now - begin);
  }

  static constexpr Duration kStep = std::chrono::milliseconds(5);
  TurretDriver driver{TurretSettings{}};
  ServoBus bus;
  TimePoint now;
  std::function<void(Bytes&)> spoil;
  double fastest_rad_s = 0.0;
};

TEST(TurretDriver, ReadsWhereTheHeadIsBeforeAnythingMoves) {
  Head head;
  EXPECT_FALSE(head.driver.ok());
  head.run(0.2);
  EXPECT_TRUE(head.driver.ok());
  EXPECT_NEAR(head.driver.pose().pan_rad, 0.8, 0.004);
  EXPECT_NEAR(head.driver.pose().tilt_rad, -0.3, 0.004);
  EXPECT_EQ(head.fastest_rad_s, 0.0) << "nobody has commanded anything";
  EXPECT_NEAR(head.driver.pan().voltage_v, 12.0, 1e-9);
  EXPECT_EQ(head.driver.tilt().temperature_c, 35);
}

TEST(TurretDriver, MovesWithinItsLimitsOfSpeedAndAngle) {
  Head head;
  head.driver.command({9.0, std::nan("")});
  head.run(2.0);
  EXPECT_NEAR(head.driver.pose().pan_rad, 1.5, 0.01);
  EXPECT_NEAR(head.driver.pose().tilt_rad, -0.3, 0.004) << "what is no number moves nothing";
  head.driver.command({-0.5, 0.2});
  head.run(3.0);
  EXPECT_NEAR(head.driver.pose().pan_rad, -0.5, 0.01);
  EXPECT_NEAR(head.driver.pose().tilt_rad, 0.2, 0.01);
  EXPECT_LT(head.fastest_rad_s, 1.02);
}

TEST(TurretDriver, ASilentServoDoesNotHoldUpTheOther) {
  Head head;
  head.run(0.2);
  head.bus.servos[1].connected = false;
  EXPECT_LT(head.run_until([&] { return head.driver.tilt().silent; }), 0.5);
  head.driver.command({0.0, 0.0});
  head.run(2.0);
  EXPECT_NEAR(head.driver.pose().pan_rad, 0.0, 0.01);
  EXPECT_FALSE(head.driver.ok());
  EXPECT_GT(head.driver.tilt().missed, 5u);
  head.bus.servos[1].connected = true;
  head.run(0.2);
  EXPECT_TRUE(head.driver.ok());
}

TEST(TurretDriver, ABlockedServoIsStuckAndThenTripsUntilReset) {
  Head head;
  head.run(0.2);
  head.bus.servos[0].blocked = true;
  head.driver.command({0.0, 0.0});
  const double took_s = head.run_until([&] { return head.driver.pan().stuck; });
  EXPECT_GT(took_s, 0.9);
  EXPECT_LT(took_s, 1.1);
  EXPECT_NEAR(head.driver.pan().load, -0.98, 0.01) << "it pushes clockwise";
  EXPECT_LT(head.run_until([&] { return head.driver.pan().tripped; }), 1.3);
  head.bus.servos[0].blocked = false;
  head.run(2.0);
  EXPECT_NEAR(head.bus.servos[0].angle_rad(), 0.8, 0.01) << "it does not start by itself";
  head.driver.reset();
  head.run(1.0);
  EXPECT_NEAR(head.bus.servos[0].angle_rad(), 0.8, 0.01);
  EXPECT_TRUE(head.driver.ok());
  head.driver.command({0.0, 0.0});
  head.run(2.0);
  EXPECT_NEAR(head.driver.pose().pan_rad, 0.0, 0.01);
}

TEST(TurretDriver, AGoalThatMovesOnDoesNotExcuseAServoThatDoesNot) {
  Head head;
  head.run(0.2);
  head.bus.servos[0].blocked = true;
  const TimePoint begin = head.now;
  while (!head.driver.pan().stuck && head.now - begin < std::chrono::seconds(3)) {
    head.driver.command({0.5 * to_seconds(head.now - begin) - 1.0, -0.3});
    head.step();
  }
  EXPECT_LT(to_seconds(head.now - begin), 1.1);
}

TEST(TurretDriver, AServoThatFollowsAGoalThatMovesOnIsNotStuck) {
  Head head;
  head.run(0.2);
  for (double t = 0.0; t < 4.0; t += to_seconds(Head::kStep)) {
    head.driver.command({0.8 - 0.4 * t, -0.3});  // always a little behind
    head.step();
    ASSERT_TRUE(head.driver.ok()) << t;
  }
  EXPECT_LT(head.driver.pose().pan_rad, -0.6);
}

TEST(TurretDriver, ACommandBeforeTheFirstReplyIsNotCountedAgainstTheServo) {
  Head head;
  head.bus.servos[0].connected = head.bus.servos[1].connected = false;
  head.driver.command({0.0, 0.0});
  head.run(3.0);
  head.bus.servos[0].connected = head.bus.servos[1].connected = true;
  head.run_until([&] { return head.driver.pan().known && head.driver.tilt().known; });
  EXPECT_TRUE(head.driver.ok());
  for (int i = 0; i < 300; ++i) {
    head.step();
    ASSERT_TRUE(head.driver.ok()) << "it moves to where it was told to";
  }
  EXPECT_NEAR(head.driver.pose().pan_rad, 0.0, 0.01);
}

TEST(TurretDriver, LostAndSpoiledRepliesAreAskedForAgain) {
  Head head;
  int count = 0;
  head.spoil = [&](Bytes& bytes) {
    if (bytes.empty()) return;
    if (++count % 7 == 0) bytes.clear();
    if (count % 11 == 0 && bytes.size() > 6) bytes[5] ^= 4;
  };
  head.driver.command({0.0, 0.0});
  head.run(3.0);
  EXPECT_NEAR(head.driver.pose().pan_rad, 0.0, 0.01);
  EXPECT_TRUE(head.driver.ok());
  EXPECT_GT(head.driver.pan().missed, 0u);
  EXPECT_GT(head.driver.counters().bad_sum, 0u);
}

TEST(TurretDriver, RepliesThatAreLateAreNotTakenForNewOnes) {
  for (int late_steps = 7; late_steps < 620; late_steps += 11) {  // 35 ms .. 3.1 s
    Head head;
    std::deque<Bytes> under_way;
    bool from_servos = false;
    int late = 0;
    head.spoil = [&](Bytes& bytes) {
      from_servos = !from_servos;
      if (from_servos) return;
      under_way.push_back(std::exchange(bytes, {}));
      while (under_way.size() > static_cast<std::size_t>(late)) {
        append(bytes, under_way.front());
        under_way.pop_front();
      }
    };
    head.run(0.5);
    ASSERT_TRUE(head.driver.ok());
    const double seen_rad = head.driver.pose().pan_rad;
    late = late_steps;
    head.driver.command({0.0, 0.0});
    int fresh = 0;
    for (int i = 0; i < 1200; ++i) {
      head.step();
      if (head.driver.ok() && i > 60) ++fresh;
    }
    EXPECT_EQ(fresh, 0) << late_steps;
    EXPECT_NEAR(head.driver.pose().pan_rad, seen_rad, 0.1) << "nothing old was believed";
  }
}

TEST(TurretDriver, AHeadThatIsStuckMakesTheRobotStand) {
  Head head;
  TestBed bed;
  bed.drive();
  head.run(0.2);
  const auto step = [&] {
    for (int i = 0; i < 2; ++i) head.step();
    bed.driver.gate().set_head_ok(head.driver.ok(), bed.now);
    bed.step();
  };
  for (int i = 0; i < 20; ++i) step();
  ASSERT_FALSE(bed.firmware.commanded_to_stand());
  head.bus.servos[0].blocked = true;
  head.driver.command({0.0, 0.0});
  double took_s = 0.0;
  for (; !bed.firmware.commanded_to_stand() && took_s < 5.0; took_s += 0.01) step();
  RecordProperty("seconds", std::to_string(took_s));
  EXPECT_LT(took_s, 1.1) << "a second without progress";
  EXPECT_EQ(bed.driver.gate().reason(), HoldReason::head_fails);
  for (int i = 0; i < 300; ++i) step();
  EXPECT_EQ(bed.firmware.forward_m_s(), 0.0);
}

TEST(TurretDriver, AHeadThatIsNotHeardOfAnyMoreMakesTheRobotStand) {
  TestBed bed;
  bed.drive();
  bed.driver.gate().set_head_ok(true, bed.now);
  const double took_s = bed.run_until([&] { return bed.firmware.commanded_to_stand(); });
  EXPECT_GT(took_s, 0.45);
  EXPECT_LT(took_s, 0.55);
  EXPECT_EQ(bed.driver.gate().reason(), HoldReason::head_fails);
}

TEST(ServoBus, AnswersTheRecordedClientAsTheRealServosDid) {
  for (const auto& file : reference::servo_captures()) {
    SCOPED_TRACE(file);
    ServoBus bus({ServoModel(1, 0.0), ServoModel(2, 0.0)});
    int asked = 0, answered = 0;
    for (const auto& chunk : reference::read_capture(file)) {
      if (chunk.direction != "H>S") continue;
      ++asked;
      bus.receive(chunk.bytes);
      if (!bus.take_output().empty()) ++answered;
    }
    EXPECT_EQ(asked, 40);
    EXPECT_EQ(answered, 37) << "all but broadcasts and the servo that is not there";
  }
}

}  // namespace
}  // namespace striate::pioneer
