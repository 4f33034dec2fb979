#pragma once

#include "striate/behaviours/control/behaviour.hpp"
#include "striate/config/settings.hpp"
#include "striate/platform/interface/robot.hpp"

namespace striate::behaviours {

/// Turns on the spot: by an angle, or to a heading that counts from the corridor's axis (0 deg
/// faces along it, 180 deg back). An angle beyond half a turn is turned in full.
class TurnTo : public Behaviour {
 public:
  struct Settings {
    double heading_rad = 0.0;
    double by_rad = 0.0;
    double rate_rad_s = 0.7;  ///< by hand, below the 1.2 rad/s that the body allows
  };
  TurnTo(const Settings& settings, const RobotDescription& robot);
  void start(const memory::ShortTermMemory& memory) override;
  Wish tick(const memory::ShortTermMemory& memory) override;

 private:
  Settings settings_;
  double left_rad_ = 0.0;
  double last_heading_rad_ = 0.0;
  double least_left_rad_ = 0.0;
  TimePoint least_left_at_{};
};

template <class V>
void visit(V& v, TurnTo::Settings& s) {
  using config::Unit;
  v.number("heading", s.heading_rad, Unit::angle, {-6.3, 6.3},
           "to this heading; 0 deg is along the corridor");
  v.number("by", s.by_rad, Unit::angle, {-12.6, 12.6},
           "by this angle, left positive; goes before 'heading'");
  v.number("rate", s.rate_rad_s, Unit::turn_rate, {0.05, 1.2}, "how fast");
}

}  // namespace striate::behaviours
