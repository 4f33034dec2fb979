#include "platform/pioneer/pioneer_robot.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <thread>

namespace striate::pioneer {
namespace {

constexpr Duration kSonarFresh = std::chrono::milliseconds(700);

RangeReading from_axle(const Pose2& disc, double range_m) {
  if (!std::isfinite(range_m)) return {disc.heading_rad, range_m};
  const Point2 hit = to_outer(disc, Point2{range_m, 0.0});
  return {std::atan2(hit.y_m, hit.x_m), std::hypot(hit.x_m, hit.y_m)};
}

}  // namespace

void fill_senses(const BaseState& base, TimePoint now, Senses& senses) {
  senses.now = now;
  senses.odometry = base.odometry;
  senses.sonar.readings.clear();
  senses.sonar.stamp = {};
  for (std::size_t disc = 0; disc < kSonarDiscs; ++disc) {
    const DiscReading& reading = base.sonar[disc];
    if (!reading.told || now - reading.stamp > kSonarFresh) continue;
    senses.sonar.readings.push_back(from_axle(sonar_disc(disc), reading.range_m));
    senses.sonar.stamp = std::max(senses.sonar.stamp, reading.stamp);
  }
  senses.laser = base.laser;
  senses.battery_v = base.battery_v;
  senses.bumper = base.bumper_front || base.bumper_rear;
  senses.motors_stalled = base.stalled_left || base.stalled_right;
}

PioneerRobot::PioneerRobot(const BaseDriverSettings& settings, const std::string& url,
                           Duration patience)
    : driver_(settings, make_transport(url), clock_) {
  if (!driver_.wait_until_it_can_drive(patience)) {
    const DriverReport report = driver_.report();
    throw std::runtime_error(
        url + ": " +
        (report.trouble.empty() ? "the robot's motors do not come on" : report.trouble));
  }
  const DriverReport report = driver_.report();
  description_.max_forward_m_s = report.most_forward_m_s;
  description_.max_turn_rad_s = report.most_turn_rad_s;
  description_.max_acceleration_m_s2 = settings.session.acceleration_m_s2;
  description_.max_turn_acceleration_rad_s2 = settings.session.turn_acceleration_rad_s2;
  next_cycle_ = clock_.now();
}

bool PioneerRobot::sense(Senses& senses) {
  next_cycle_ = std::max(next_cycle_ + description_.cycle, clock_.now());
  std::this_thread::sleep_for(next_cycle_ - clock_.now());
  const DriverReport report = driver_.report();
  fill_senses(report.base, clock_.now(), senses);
  // Not by the reason alone: a higher one may hide that the link is gone.
  if (report.state != SessionState::ready || report.hold == HoldReason::link_lost) {
    throw std::runtime_error("the robot is lost: " + report.trouble);
  }
  return true;
}

void PioneerRobot::stop() noexcept {
  try {
    driver_.command({});
  } catch (...) {  // a lock that fails: the lease ends by itself
  }
}

}  // namespace striate::pioneer
