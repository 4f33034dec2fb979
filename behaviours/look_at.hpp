#pragma once

#include <cstdint>

#include "striate/behaviours/control/behaviour.hpp"
#include "striate/config/settings.hpp"
#include "striate/platform/interface/robot.hpp"

namespace striate::behaviours {

/// Turns the head to a direction, or to what short-term memory holds as most salient, and looks
/// there for a while. The choice is made once; the region is then followed while it is remembered.
class LookAt : public Behaviour {
 public:
  enum class Target : std::uint8_t { direction, salient };
  struct Settings {
    Target target = Target::direction;
    double pan_rad = 0.0;
    double tilt_rad = RobotDescription{}.resting_tilt_rad;
    double for_s = 1.0;
  };

  /// With the head's resting tilt of that robot.
  [[nodiscard]] static Settings defaults_for(const RobotDescription& robot) {
    return {.tilt_rad = robot.resting_tilt_rad};
  }
  LookAt(const Settings& settings, const RobotDescription& robot);
  void start(const memory::ShortTermMemory& memory) override;
  Wish tick(const memory::ShortTermMemory& memory) override;
  [[nodiscard]] Motors motors() const override { return Motors::head; }

 private:
  /// Where the chosen region is now; false once it is forgotten.
  bool follow(const memory::ShortTermMemory& memory);

  Settings settings_;
  double max_pan_rad_;
  double pan_rad_ = 0.0;
  int region_ = 0;
  TimePoint started_{};
  TimePoint arrived_{};
  bool there_ = false;
};

template <class V>
void visit(V& v, LookAt::Settings& s) {
  using config::Unit;
  v.choice("target", s.target, {"direction", "salient"}, "'pan' and 'tilt', or what is salient");
  v.number("pan", s.pan_rad, Unit::angle, {-1.6, 1.6}, "left positive");
  v.number("tilt", s.tilt_rad, Unit::angle, {-0.6, 0.6}, "up positive");
  v.number("for", s.for_s, Unit::duration, {0, 600}, "how long it looks there");
}

}  // namespace striate::behaviours
