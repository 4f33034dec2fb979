#pragma once

#include "striate/behaviours/control/behaviour.hpp"
#include "striate/config/settings.hpp"
#include "striate/platform/interface/robot.hpp"

namespace striate::behaviours {

/// Stands still; succeeds when the robot stands.
class Stop : public Behaviour {
 public:
  struct Settings {};
  Stop(const Settings& /*settings*/, const RobotDescription& /*robot*/) {}
  void start(const memory::ShortTermMemory& /*memory*/) override {}
  Wish tick(const memory::ShortTermMemory& memory) override;
  [[nodiscard]] Motors motors() const override { return Motors::wheels; }
  [[nodiscard]] bool can_fail() const override { return false; }
};

template <class V>
void visit(V& /*v*/, Stop::Settings& /*s*/) {}

}  // namespace striate::behaviours
