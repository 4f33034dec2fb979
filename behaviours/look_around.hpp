#pragma once

#include "striate/behaviours/control/behaviour.hpp"
#include "striate/config/settings.hpp"
#include "striate/platform/interface/robot.hpp"

namespace striate::behaviours {

/// Turns the head to the left, to the right and back, looking far and then near on each side.
class LookAround : public Behaviour {
 public:
  struct Settings {
    double pan_rad = 1.0472;
    double dwell_s = 0.7;
  };
  LookAround(const Settings& settings, const RobotDescription& robot);
  void start(const memory::ShortTermMemory& memory) override;
  Wish tick(const memory::ShortTermMemory& memory) override;
  [[nodiscard]] Motors motors() const override { return Motors::head; }
  [[nodiscard]] bool can_fail() const override { return false; }

 private:
  Settings settings_;
  RobotDescription robot_;
  int step_ = 0;
  TimePoint step_began_{};
  TimePoint arrived_{};
  bool there_ = false;
};

template <class V>
void visit(V& v, LookAround::Settings& s) {
  using config::Unit;
  v.number("pan", s.pan_rad, Unit::angle, {0.05, 1.6}, "how far to each side");
  v.number("dwell", s.dwell_s, Unit::duration, {0.1, 30}, "how long it looks each time");
}

}  // namespace striate::behaviours
