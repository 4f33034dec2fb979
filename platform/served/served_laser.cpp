#include "striate/platform/served/served_laser.hpp"

#include <cmath>

#include "striate/base/geometry.hpp"

namespace striate::served {

ServedLaser::ServedLaser(pioneer::LaserKind kind) {
  if (kind == pioneer::LaserKind::lms200) device_.emplace<pioneer::LmsDevice>();
}

void ServedLaser::receive(ByteView bytes) {
  std::visit([&](auto& device) { device.receive(bytes); }, device_);
}

Bytes ServedLaser::take_output() {
  return std::visit([](auto& device) { return device.take_output(); }, device_);
}

void ServedLaser::reboot() {
  std::visit([](auto& device) { device.reboot(); }, device_);
}

std::uint64_t ServedLaser::understood() const {
  return std::visit([](const auto& device) { return device.understood(); }, device_);
}

bool ServedLaser::streams() const {
  return std::visit([](const auto& device) { return device.streams(); }, device_);
}

void ServedLaser::step(TimePoint now, const Range& range) {
  std::visit([&](auto& device) { turn(device, now, range); }, device_);
}

void ServedLaser::turn(pioneer::UrgDevice& urg, TimePoint now, const Range& range) const {
  urg.set_time(now);
  if (!urg.measures(now)) return;
  const pioneer::scip::Parameters& p = urg.parameters();
  std::vector<int> ranges_mm;
  ranges_mm.reserve(urg.rays());
  for (int step = p.first_step; step <= p.last_step; ++step) {
    const double range_mm = 1000.0 * range(radians(360.0 * (step - p.front_step) / p.steps_a_turn));
    // Nothing within range is told as a range that is too short to be one.
    ranges_mm.push_back(range_mm > p.farthest_mm ? 0 : static_cast<int>(std::lround(range_mm)));
  }
  urg.step(now, ranges_mm);
}

void ServedLaser::turn(pioneer::LmsDevice& lms, TimePoint now, const Range& range) const {
  std::vector<double> ranges_m;
  if (lms.measures(now)) {
    for (const double bearing_rad : lms.bearings_rad()) ranges_m.push_back(range(bearing_rad));
  }
  lms.step(now, ranges_m);
}

}  // namespace striate::served
