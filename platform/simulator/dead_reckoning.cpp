#include "striate/platform/simulator/dead_reckoning.hpp"

#include <cmath>

#include "striate/base/pioneer_devices.hpp"

namespace striate::simulator {
namespace {

/// Slip of single steps: after 1 m of 10 ms steps this adds up to about 1 mrad.
/// Slip of single steps adds up to 1 mrad after 1 m, below the run's own scales (ours)
constexpr double kSlip_rad_per_root_m = 0.001;

}  // namespace

DeadReckoning::DeadReckoning(std::uint64_t seed, const SensorSettings& settings)
    : random_(seed, Purpose::odometry) {
  // The first draws are the run's own scales; the steps use the rest.
  way_scale_ = 1.0 + settings.odometry_way_error * random_.normal(0);
  turn_scale_ = 1.0 + settings.odometry_turn_error * random_.normal(1);
  drift_rad_m_ = settings.odometry_drift_rad_m * random_.normal(2);
}

void DeadReckoning::step(double dt_s, double forward_m_s, double turn_rad_s) {
  forward_m_s_ = forward_m_s;
  turn_rad_s_ = turn_rad_s;
  const double way = forward_m_s * dt_s;
  ++steps_;
  if (way == 0.0 && turn_rad_s == 0.0) return;
  const double slip = kSlip_rad_per_root_m * std::sqrt(std::abs(way)) * random_.normal(2 + steps_);
  const double turned = turn_scale_ * turn_rad_s * dt_s + drift_rad_m_ * way + slip;
  const double heading = pose_.heading_rad + turned / 2;
  pose_.x_m += way_scale_ * way * std::cos(heading);
  pose_.y_m += way_scale_ * way * std::sin(heading);
  pose_.heading_rad = wrap_angle(pose_.heading_rad + turned);
}

Odometry DeadReckoning::reported(TimePoint now) const {
  constexpr double kStep_m = 0.001;  // 1 mm, and 1 mm/s: as a SIP tells it; ARCOS manual
  const auto stepped = [](double value, double step) { return std::round(value / step) * step; };
  Odometry odometry;
  odometry.stamp = now;
  odometry.pose = {stepped(pose_.x_m, kStep_m), stepped(pose_.y_m, kStep_m),
                   stepped(pose_.heading_rad, kHeadingCount_rad)};
  odometry.forward_m_s = stepped(way_scale_ * forward_m_s_, kStep_m);
  odometry.turn_rad_s = stepped(turn_scale_ * turn_rad_s_, kStep_m);
  return odometry;
}

}  // namespace striate::simulator
