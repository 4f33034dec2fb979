#pragma once

#include <cstdint>

#include "striate/behaviours/control/behaviour.hpp"
#include "striate/behaviours/navigation/path_follower.hpp"
#include "striate/config/settings.hpp"

namespace striate::behaviours {

/// Drives along the corridor: keeps its heading and its middle (or a side), goes round what
/// stands in it, and always returns to the first heading. Runs until it is halted, or until
/// `distance` is made good along the corridor. The direction is the one of the corridor's two that
/// the robot faces at the start; tried again after a failure it goes on in the direction it had,
/// because the search for a gap may have turned the robot round.
class TraverseCorridor : public Behaviour {
 public:
  enum class Keep : std::uint8_t { middle, left, right };
  struct Settings {
    double speed_m_s = 0.45;  ///< by hand; the shipped mission asks for 0.65 m/s
    Keep keep = Keep::middle;
    double beside_m = 0.65;  ///< by hand: 0.44 m beside the flank, full pace needs 0.35 m
    double distance_m = 0.0;
    DrivingSettings driving;
  };

  TraverseCorridor(const Settings& settings, const RobotDescription& robot);
  void start(const memory::ShortTermMemory& memory) override;
  Wish tick(const memory::ShortTermMemory& memory) override;
  [[nodiscard]] bool ends_by_itself() const override { return settings_.distance_m > 0.0; }
  [[nodiscard]] const PathFollower& follower() const { return follower_; }

 private:
  Settings settings_;
  PathFollower follower_;
  bool back_ = false;    ///< against the axis
  bool failed_ = false;  ///< the last time that it ran
};

template <class V>
void visit(V& v, TraverseCorridor::Settings& s) {
  using config::Unit;
  v.number("speed", s.speed_m_s, Unit::speed, {0.05, 0.75}, "where all is known to be free");
  v.choice("keep", s.keep, {"middle", "left", "right"}, "which part of the corridor");
  v.number("beside", s.beside_m, Unit::length, {0.35, 3},
           "distance to the wall when a side is kept");
  v.number("distance", s.distance_m, Unit::length, {0, 10000},
           "succeeds after so much way along the corridor; 0 m: runs on");
  v.section("driving", s.driving);
}

/// The course along the remembered corridor: `back` against its axis. Used by all that travel.
[[nodiscard]] Course corridor_course(const memory::CorridorMemory& corridor, bool back,
                                     double cruise_m_s);

}  // namespace striate::behaviours
