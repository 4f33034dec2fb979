#pragma once

#include "striate/behaviours/control/behaviour.hpp"
#include "striate/behaviours/navigation/straight_line.hpp"
#include "striate/config/settings.hpp"
#include "striate/platform/interface/robot.hpp"

namespace striate::behaviours {

/// Drives straight ahead over a distance, keeping the heading it began with.
class DriveStraight : public Behaviour {
 public:
  struct Settings {
    double distance_m = 1.0;
    double speed_m_s = 0.30;  ///< by hand: it does not go round things
  };
  DriveStraight(const Settings& settings, const RobotDescription& /*robot*/)
      : line_(settings.distance_m, settings.speed_m_s) {}
  void start(const memory::ShortTermMemory& memory) override { line_.start(memory); }
  Wish tick(const memory::ShortTermMemory& memory) override { return line_.tick(memory); }
  [[nodiscard]] Motors motors() const override { return Motors::wheels; }

 private:
  StraightLine line_;
};

template <class V>
void visit(V& v, DriveStraight::Settings& s) {
  using config::Unit;
  v.number("distance", s.distance_m, Unit::length, {0.02, 100}, "how far");
  v.number("speed", s.speed_m_s, Unit::speed, {0.05, 0.75}, "how fast");
}

}  // namespace striate::behaviours
