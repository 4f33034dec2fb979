#pragma once

#include "striate/behaviours/control/behaviour.hpp"
#include "striate/behaviours/navigation/path_follower.hpp"
#include "striate/config/settings.hpp"

namespace striate::behaviours {

/// Goes round what stands ahead or lets it pass: gaps are tested against the robot's outline with
/// margin in short-term memory, people are waited for, and it backs out where no gap is left.
/// Succeeds when the straight way ahead has been open for a moment.
class Avoid : public Behaviour {
 public:
  struct Settings {
    double speed_m_s = 0.30;  ///< by hand: slower than on an open way
    double open_m = 1.5;      ///< by hand: more than twice the way to stop from 0.75 m/s (0.68 m)
    DrivingSettings driving;
  };

  Avoid(const Settings& settings, const RobotDescription& robot);
  void start(const memory::ShortTermMemory& memory) override;
  Wish tick(const memory::ShortTermMemory& memory) override;

 private:
  [[nodiscard]] bool straight_path_open(const memory::ShortTermMemory& memory,
                                        const Course& course) const;
  Settings settings_;
  RobotDescription robot_;
  PathFollower follower_;
  bool back_ = false;
  int open_ticks_ = 0;
};

template <class V>
void visit(V& v, Avoid::Settings& s) {
  using config::Unit;
  v.number("speed", s.speed_m_s, Unit::speed, {0.05, 0.75}, "at most");
  v.number("open", s.open_m, Unit::length, {0.3, 4},
           "so much straight way must be open at the end");
  v.section("driving", s.driving);
}

}  // namespace striate::behaviours
