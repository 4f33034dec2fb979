#pragma once

#include "behaviours/behaviour.hpp"
#include "config/settings.hpp"
#include "platform/interface/robot.hpp"

namespace striate {

/// Stands still; succeeds when the robot stands.
class Stop : public Behaviour {
 public:
  struct Settings {};
  Stop(const Settings& /*settings*/, const RobotDescription& /*robot*/) {}
  void start(const ShortTermMemory& /*memory*/) override {}
  Wish tick(const ShortTermMemory& memory) override;
  [[nodiscard]] Motors motors() const override { return Motors::wheels; }
  [[nodiscard]] bool can_fail() const override { return false; }
};

template <class V>
void visit(V& /*v*/, Stop::Settings& /*s*/) {}

}  // namespace striate
