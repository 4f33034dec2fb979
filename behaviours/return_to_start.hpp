#pragma once

#include "striate/behaviours/control/behaviour.hpp"
#include "striate/behaviours/navigation/journey.hpp"
#include "striate/behaviours/turn_to.hpp"
#include "striate/config/settings.hpp"

namespace striate::behaviours {

/// The way back to where the run began, along the robot's own trail, also when new obstacles stand
/// in it. Succeeds near the start; with `facing` after it has turned to the first heading.
class ReturnToStart : public Behaviour {
 public:
  struct Settings {
    double speed_m_s = 0.45;
    double within_m = 0.6;
    bool facing = false;
    DrivingSettings driving{};
  };

  ReturnToStart(const Settings& settings, const RobotDescription& robot);
  void start(const memory::ShortTermMemory& memory) override;
  Wish tick(const memory::ShortTermMemory& memory) override;

 private:
  Settings settings_;
  Journey journey_;
  TurnTo turn_;
  bool there_ = false;
};

template <class V>
void visit(V& v, ReturnToStart::Settings& s) {
  using config::Unit;
  v.number("speed", s.speed_m_s, Unit::speed, {0.05, 0.75}, "where all is known to be free");
  v.number("within", s.within_m, Unit::length, {0.2, 5}, "so near is there");
  v.flag("facing", s.facing, "turns to the first heading at the end");
  v.section("driving", s.driving);
}

}  // namespace striate::behaviours
