#pragma once

#include "striate/behaviours/control/behaviour.hpp"
#include "striate/config/settings.hpp"
#include "striate/platform/interface/robot.hpp"

namespace striate::behaviours {

/// Stands for a while.
class Wait : public Behaviour {
 public:
  struct Settings {
    double for_s = 1.0;
  };
  static constexpr const char* kMain = "for";  ///< `- wait: 3 s`
  Wait(const Settings& settings, const RobotDescription& /*robot*/) : settings_(settings) {}
  void start(const memory::ShortTermMemory& memory) override { started_ = memory.now(); }
  Wish tick(const memory::ShortTermMemory& memory) override;
  [[nodiscard]] Motors motors() const override { return Motors::nothing; }
  [[nodiscard]] bool can_fail() const override { return false; }

 private:
  Settings settings_;
  TimePoint started_{};
};

template <class V>
void visit(V& v, Wait::Settings& s) {
  v.number("for", s.for_s, config::Unit::duration, {0, 86400}, "how long");
}

}  // namespace striate::behaviours
