#pragma once

#include <string>

#include "striate/behaviours/control/behaviour.hpp"
#include "striate/behaviours/navigation/journey.hpp"
#include "striate/config/settings.hpp"

namespace striate::behaviours {

/// Drives to the place of a landmark that the robot knows: recognised in this run, or recalled by
/// long-term memory. Each look at it on the way corrects where it is, and so the course. Succeeds
/// within `stop_at` of it.
class GoTo : public Behaviour {
 public:
  struct Settings {
    std::string landmark;
    double stop_at_m = 1.2;
    double speed_m_s = 0.45;
    DrivingSettings driving{};
  };
  static constexpr const char* kMain = "landmark";
  static constexpr const char* kRequired[] = {"landmark"};

  GoTo(const Settings& settings, const RobotDescription& robot)
      : settings_(settings), journey_(settings.driving, robot) {}
  void start(const memory::ShortTermMemory& memory) override { journey_.start(memory); }
  Wish tick(const memory::ShortTermMemory& memory) override;

 private:
  Settings settings_;
  Journey journey_;
};

template <class V>
void visit(V& v, GoTo::Settings& s) {
  using config::Unit;
  v.text("landmark", s.landmark, "the landmark's name");
  v.number("stop_at", s.stop_at_m, Unit::length, {0.3, 10}, "so near to it is there");
  v.number("speed", s.speed_m_s, Unit::speed, {0.05, 0.75}, "where all is known to be free");
  v.section("driving", s.driving);
}

}  // namespace striate::behaviours
