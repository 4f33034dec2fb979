#pragma once

#include <cmath>

#include "striate/behaviours/control/behaviour.hpp"
#include "striate/config/settings.hpp"
#include "striate/platform/interface/robot.hpp"

namespace striate::behaviours {

struct NodSettings {
  double tilt_rad = 0.2;
  double for_s = 2.0;
};

template <class V>
void visit(V& v, NodSettings& s) {
  v.number("tilt", s.tilt_rad, config::Unit::angle, {0.0, 0.5}, "how far up and down");
  v.number("for", s.for_s, config::Unit::duration, {0.1, 60.0}, "how long");
}

/// Nods: the head goes up and down about its resting tilt.
class Nod final : public Behaviour {
 public:
  using Settings = NodSettings;
  static constexpr const char* kMain = "for";  // `- nod: 3 s` is short for `- nod: {for: 3 s}`

  Nod(const Settings& settings, const RobotDescription& /*robot*/) : settings_(settings) {}
  void start(const memory::ShortTermMemory& memory) override { began_ = memory.now(); }
  Wish tick(const memory::ShortTermMemory& memory) override {
    const double t_s = to_seconds(memory.now() - began_);
    if (t_s > settings_.for_s) return final_wish(memory, Progress::succeeded, "nodded");
    Wish wish = standing_wish(memory, "nods");
    wish.tilt_rad += settings_.tilt_rad * std::sin(6.0 * t_s);
    return wish;
  }
  // For the checker of task scripts: it may run together with what moves the wheels alone.
  [[nodiscard]] Motors motors() const override { return Motors::head; }
  [[nodiscard]] bool can_fail() const override { return false; }

 private:
  Settings settings_;
  TimePoint began_;
};

}  // namespace striate::behaviours
