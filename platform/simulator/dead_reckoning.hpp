#pragma once

#include "striate/platform/interface/senses.hpp"
#include "striate/platform/simulator/random.hpp"
#include "striate/platform/simulator/simulator_settings.hpp"

namespace striate::simulator {

/// What the wheels' encoders make of the way: scales of way and turn that are a little wrong, a
/// drift, and noise, all drawn anew for each seed.
class DeadReckoning {
 public:
  DeadReckoning(std::uint64_t seed, const SensorSettings& settings);

  /// One step: how far the wheels turned, the true speeds of base and turn.
  void step(double dt_s, double forward_m_s, double turn_rad_s);
  /// As the base reports it, in its own steps of 1 mm and 2 pi / 4096.
  [[nodiscard]] Odometry reported(TimePoint now) const;

 private:
  Random random_;
  double way_scale_ = 1.0;
  double turn_scale_ = 1.0;
  double drift_rad_m_ = 0.0;
  std::uint64_t steps_ = 0;
  Pose2 pose_;
  double forward_m_s_ = 0.0;
  double turn_rad_s_ = 0.0;
};

}  // namespace striate::simulator
