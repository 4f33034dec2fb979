#include "striate/platform/pioneer/driver_thread.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "striate/platform/pioneer/steady_clock.hpp"
#include "tests/unit/pioneer/test_bed.hpp"

namespace striate::pioneer {
namespace {

using namespace std::chrono_literals;

/// A line with a robot at its other end that lives in the driver's own thread.
class RobotLine final : public Transport {
 public:
  explicit RobotLine(const Clock& clock, std::atomic<double>& forward_m_s)
      : clock_(clock), forward_m_s_(forward_m_s), firmware_(FirmwareSettings{}) {}
  void open() override { open_ = true; }
  void close() override { open_ = false; }
  [[nodiscard]] bool is_opening() const override { return false; }
  [[nodiscard]] bool is_open() const override { return open_; }
  [[nodiscard]] Bytes read() override {
    const TimePoint now = clock_.now();
    FirmwareSenses felt;
    felt.odometry.forward_m_s = firmware_.forward_m_s();
    firmware_.step(now, stepped_at_ == TimePoint() ? 5ms : now - stepped_at_, felt);
    stepped_at_ = now;
    forward_m_s_ = firmware_.forward_m_s();
    return firmware_.take_output();
  }
  void write(ByteView bytes) override {
    const bool had_motors = firmware_.motors_on();
    const double forward_m_s = firmware_.forward_m_s();
    firmware_.receive(bytes, clock_.now());
    if (had_motors && !firmware_.motors_on() && motors_off_at_m_s) *motors_off_at_m_s = forward_m_s;
  }
  void wait(Duration at_most) override { std::this_thread::sleep_for(at_most); }

  double* motors_off_at_m_s = nullptr;  ///< how fast it was when its motors went off

 private:
  const Clock& clock_;
  std::atomic<double>& forward_m_s_;
  ArcosFirmware firmware_;
  TimePoint stepped_at_;
  bool open_ = false;
};

TEST(DriverThread, DrivesStopsByItselfAndObeysTheEmergencyStop) {
  const SteadyClock clock;
  std::atomic<double> forward_m_s{0.0};
  DriverThread driver({}, std::make_unique<RobotLine>(clock, forward_m_s), clock);
  ASSERT_TRUE(driver.wait_until_it_can_drive(10s));
  const auto push = [&](int times) {
    for (int i = 0; i < times; ++i) {
      driver.command({.forward_m_s = 0.2});
      std::this_thread::sleep_for(10ms);
    }
  };
  push(50);
  EXPECT_GT(forward_m_s, 0.1);
  const TimePoint last = clock.now();
  while (forward_m_s > 0.0 && clock.now() - last < 5s) std::this_thread::sleep_for(5ms);
  EXPECT_EQ(forward_m_s, 0.0) << "nobody commands any more";
  driver.emergency_stop();
  push(30);
  EXPECT_EQ(forward_m_s, 0.0);
  EXPECT_TRUE(driver.report().latched);
  EXPECT_EQ(driver.report().hold, HoldReason::emergency);
  driver.reset();
  push(100);
  EXPECT_GT(forward_m_s, 0.1);
}

TEST(DriverThread, BrakesToAStandBeforeTheMotorsGoOff) {
  const SteadyClock clock;
  std::atomic<double> forward_m_s{0.0};
  double motors_off_at_m_s = -1.0;
  double before_m_s = 0.0;
  {
    auto line = std::make_unique<RobotLine>(clock, forward_m_s);
    line->motors_off_at_m_s = &motors_off_at_m_s;
    DriverThread driver({}, std::move(line), clock);
    ASSERT_TRUE(driver.wait_until_it_can_drive(10s));
    const TimePoint begin = clock.now();
    while (forward_m_s < 0.29 && clock.now() - begin < 5s) {
      driver.command({.forward_m_s = 0.3});
      std::this_thread::sleep_for(10ms);
    }
    before_m_s = forward_m_s;
  }
  EXPECT_GT(before_m_s, 0.25);
  EXPECT_GE(motors_off_at_m_s, 0.0) << "they did go off";
  EXPECT_LT(motors_off_at_m_s, 0.02);
}

TEST(DriverThread, TellsWhyThereIsNoRobot) {
  const SteadyClock clock;
  BaseDriverSettings settings;
  settings.session.sync_wait_s = 0.1;
  settings.session.sync_tries = 2;
  auto owned = std::make_unique<MemoryLine>();
  owned->plugged = false;
  DriverThread driver(settings, std::move(owned), clock);
  EXPECT_FALSE(driver.wait_until_it_can_drive(300ms));
  EXPECT_NE(driver.report().trouble, "");
}

}  // namespace
}  // namespace striate::pioneer
