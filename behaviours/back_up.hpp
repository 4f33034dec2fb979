#pragma once

#include "striate/behaviours/control/behaviour.hpp"
#include "striate/behaviours/navigation/behind.hpp"
#include "striate/behaviours/navigation/straight_line.hpp"
#include "striate/config/settings.hpp"
#include "striate/platform/interface/robot.hpp"

namespace striate::behaviours {

/// Drives straight back over a distance: slowly, because no eye looks there. With `known_floor` it
/// ends as failed where the floor behind was neither seen free nor driven over.
class BackUp : public Behaviour {
 public:
  struct Settings {
    double distance_m = 0.3;  ///< by hand: room to turn before a thing
    double speed_m_s = 0.12;  ///< by hand: stops within 0.06 m, no eye looks there
    bool known_floor = false;
  };
  BackUp(const Settings& settings, const RobotDescription& robot)
      : known_floor_(settings.known_floor),
        robot_(robot),
        line_(settings.distance_m, -settings.speed_m_s) {}
  void start(const memory::ShortTermMemory& memory) override { line_.start(memory); }
  Wish tick(const memory::ShortTermMemory& memory) override {
    const Wish wish = line_.tick(memory);
    if (!known_floor_ || wish.progress != Progress::running) return wish;
    if (free_behind_m(memory, robot_) > kRoomBehind_m) return wish;
    return failed_wish(memory, Failure::not_known, "the floor behind is not known");
  }
  [[nodiscard]] Motors motors() const override { return Motors::wheels; }

 private:
  bool known_floor_;
  RobotDescription robot_;
  StraightLine line_;
};

template <class V>
void visit(V& v, BackUp::Settings& s) {
  using config::Unit;
  v.number("distance", s.distance_m, Unit::length, {0.02, 5}, "how far");
  v.number("speed", s.speed_m_s, Unit::speed, {0.03, 0.3}, "how fast");
  v.flag("known_floor", s.known_floor, "only over floor that was seen free or driven over");
}

}  // namespace striate::behaviours
