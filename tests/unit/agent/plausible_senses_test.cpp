#include "striate/agent/plausible_senses.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "striate/agent/mission.hpp"
#include "striate/agent/run_result.hpp"
#include "tests/reference/temporary_folder.hpp"

namespace striate::agent {
namespace {

using testing::HasSubstr;

/// A textured wall 6 m away, as one eye sees it.
cv::Mat3b wall_seen(int shift_px) {
  cv::Mat3b image(120, 160);
  for (int v = 0; v < image.rows; ++v) {
    for (int u = 0; u < image.cols; ++u) {
      std::uint32_t x = static_cast<std::uint32_t>((u + shift_px) / 3) * 2654435761U +
                        static_cast<std::uint32_t>(v / 3) * 40503U;
      x = (x ^ (x >> 15U)) * 0x2C1B3C6DU;
      image(v, u) = cv::Vec3b::all(static_cast<std::uint8_t>(40 + (x >> 16U) % 180));
    }
  }
  return image;
}

StereoFrame seen_frame(TimePoint stamp) {
  StereoFrame frame;
  frame.stamp = stamp;
  frame.left = wall_seen(0);
  frame.right = wall_seen(4);
  frame.focal_px = 203.0;
  frame.centre_u_px = 79.5;
  frame.centre_v_px = 59.5;
  frame.baseline_m = 0.12;
  return frame;
}

/// A body on a bare floor. From some cycle on it says something else.
class Odd final : public Robot, private Clock {
 public:
  using Change = std::function<void(Senses&)>;
  Odd(int from, Change change) : from_(from), change_(std::move(change)) {}
  [[nodiscard]] const RobotDescription& description() const override { return described; }
  [[nodiscard]] const Clock& clock() const override { return *this; }
  bool sense(Senses& senses) override {
    if (++cycles_ > 60) return false;
    senses = {};
    senses.now = now();
    senses.odometry = {
        now(), {driven_m_ += 0.1 * sent_.forward_m_s, 0.0, 0.0}, sent_.forward_m_s, 0.0};
    senses.stereo = seen_frame(now());
    if (cycles_ >= from_) change_(senses);
    return true;
  }
  void send(const MotorCommand& command) override { sent_ = command; }
  void stop() noexcept override { sent_ = {}; }
  RobotDescription described;

 private:
  [[nodiscard]] TimePoint now() const override {
    return TimePoint(std::chrono::milliseconds(100 * cycles_));
  }
  int from_;
  Change change_;
  int cycles_ = 0;
  double driven_m_ = 0.0;
  MotorCommand sent_;
};

/// Drives straight with such a body, and looks at each cycle.
RunResult drive(int from, const Odd::Change& change,
                const std::function<void(const Mission&)>& look) {
  const reference::TemporaryFolder folder;
  MissionOptions options;
  options.task = folder.write("t.yaml", "striate: 1\ndo:\n  - drive_straight: {distance: 9 m}\n");
  Mission mission(options, {.wake = [&](RobotSettings&) -> Body {
                    return {.robot = std::make_unique<Odd>(from, change), .place = "odd"};
                  }});
  return mission.run([&](const Mission& m) {
    look(m);
    return false;
  });
}

TEST(PlausibleSenses, AnImageThatCannotBeIsPutAsideAndTheRobotStandsAndSaysWhy) {
  for (const double focal_px : {2.0, 4e6, std::nan("")}) {
    double fastest_before_m_s = 0.0;
    double last_m_s = 1.0;
    std::string hold;
    (void)drive(
        20, [&](Senses& senses) { senses.stereo.focal_px = focal_px; },
        [&](const Mission& mission) {
          const CycleTrace& trace = mission.cycle().trace();
          if (mission.cycles() < 20) {
            EXPECT_EQ(mission.hold(), "");
            fastest_before_m_s = std::max(fastest_before_m_s, trace.sent.forward_m_s);
          } else {
            hold = mission.hold();
            EXPECT_EQ(trace.senses.stereo.stamp, TimePoint(std::chrono::milliseconds(1900)));
            EXPECT_EQ(trace.senses.stereo.focal_px, 203.0);
          }
          last_m_s = trace.sent.forward_m_s;
        });
    EXPECT_GT(fastest_before_m_s, 0.1);
    EXPECT_EQ(last_m_s, 0.0);
    EXPECT_THAT(hold, HasSubstr("focal length"));
  }
}

TEST(PlausibleSenses, OdometryThatIsNoneEndsTheMissionWithAReason) {
  for (const double odd : {std::nan(""), 1e300}) {
    const RunResult result = drive(
        5, [&](Senses& senses) { senses.odometry.pose.x_m = odd; }, [](const Mission&) {});
    EXPECT_THAT(result.reason, HasSubstr("odometry's x"));
  }
}

TEST(PlausibleSenses, ABodyThatCannotBeIsNotDriven) {
  MissionOptions options;
  const BodySource body{.wake = [](RobotSettings&) -> Body {
    auto robot = std::make_unique<Odd>(99, Odd::Change());
    robot->described.rear_m = 1e9;
    return {.robot = std::move(robot), .place = "odd"};
  }};
  EXPECT_THROW(Mission(options, body), std::runtime_error);
}

}  // namespace
}  // namespace striate::agent
