#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "striate/base/limits.hpp"
#include "striate/behaviours/control/footprint.hpp"
#include "striate/behaviours/control/wish.hpp"
#include "striate/config/settings.hpp"
#include "striate/platform/interface/senses.hpp"

namespace striate::behaviours {

/// Ours, by hand (README.md, "Where the numbers come from").
struct SafetyLimiterSettings {
  bool emergency_layer = true;
  double stop_m = 0.06;            ///< as DrivingSettings::least_margin_m: what is planned may pass
  double emergency_stop_m = 0.04;  ///< ranges are exact: nearer than stop_m, so passing is no stop
  double slow_m = 0.60;            ///< about the way to stop from 0.70 m/s
  double slow_m_s = 0.30;          ///< stops within 0.14 m
  double latency_s = kBrakeLatency_s;  ///< command 0.06 s and a cycle of 0.1 s
  double image_slow_s = 0.25;          ///< an image arrives after 0.085 s; one or two were lost
  double image_stop_s = 0.50;          ///< 0.33 m at 0.65 m/s
  double lease_s = to_seconds(kWishLease);  ///< two cycles; the arbiter's own is the same
  double stall_pause_s = 1.0;
  double battery_slow_v = 11.2;             ///< of a lead-acid battery of 12 V
  double battery_stop_v = kEmptyBattery_v;  ///< six cells of 1.8 V, where discharging harms them
  double battery_slow_m_s = 0.20;
};

template <class V>
void visit(V& v, SafetyLimiterSettings& s) {
  using config::Unit;
  v.flag("emergency_layer", s.emergency_layer, "sonar and laser may slow and stop the robot");
  v.number("stop", s.stop_m, Unit::length, {0, 0.5}, "stands so far before what memory holds");
  v.number("emergency_stop", s.emergency_stop_m, Unit::length, {0, 0.5},
           "stands so far before an echo of sonar or laser");
  v.number("slow", s.slow_m, Unit::length, {0, 2}, "slows down so far before anything");
  v.number("slow_speed", s.slow_m_s, Unit::speed, {0.05, 0.75}, "at most this in the slow zone");
  v.number("latency", s.latency_s, Unit::duration, {0, 1}, "from command to braking");
  v.renamed("picture_slow", "image_slow");
  v.number("image_slow", s.image_slow_s, Unit::duration, {0.1, 5},
           "slows down when the newest image is older");
  v.renamed("picture_stop", "image_stop");
  v.number("image_stop", s.image_stop_s, Unit::duration, {0.1, 5},
           "stands when the newest image is older");
  v.number("lease", s.lease_s, Unit::duration, {0.05, 2}, "an older wish does not drive");
  v.number("stall_pause", s.stall_pause_s, Unit::duration, {0, 10},
           "after a stall no push the same way for so long");
  v.number("battery_slow", s.battery_slow_v, Unit::none, {0, 60}, "volts: below it drives slowly");
  v.number("battery_stop", s.battery_stop_v, Unit::none, {0, 60}, "volts: below it stands");
  v.number("battery_slow_speed", s.battery_slow_m_s, Unit::speed, {0.05, 0.75},
           "at most this with a low battery");
}

/// Why the limiter lowered a wish; the strongest reason of a cycle.
enum class LimitReason : std::uint8_t {
  none,
  acceleration,
  battery_low,
  slow_zone,
  memory_stop,
  image_old,
  wish_old,
  stalled,
  emergency_range,
  bumper,
};
[[nodiscard]] const char* name_of(LimitReason reason);

/// What the limiter lets through, and why it is less than the wish.
struct Limited {
  MotorCommand command;
  LimitReason reason = LimitReason::none;
  /// What the emergency layer stepped in for, robot frame; valid until the next call.
  std::span<const Point2> held_by;
};

/// The last and only gate to the motors. It may only slow down or stop, never add motion; and it
/// slows only motion that leads towards a thing, so the robot can always turn or back away.
/// Sonar, laser and bumper are the emergency layer; short-term memory always counts.
class SafetyLimiter {
 public:
  SafetyLimiter(const SafetyLimiterSettings& settings, const RobotDescription& robot);

  /// The command to send, from the wish, what is felt now and what is remembered.
  Limited limit(const Wish& wish, const Senses& senses, const memory::ShortTermMemory& memory);

  /// How often sonar, laser or bumper stepped in: each time they begin to take more than half of
  /// the speed away that was wished and otherwise allowed.
  [[nodiscard]] int emergency_stops() const { return emergency_stops_; }

 private:
  struct Motion {
    double forward_m_s = 0.0;
    double turn_rad_s = 0.0;
  };
  /// Scales the motion and notes the reason if that is lower than the scale so far.
  struct Scale {
    double factor = 1.0;
    LimitReason reason = LimitReason::none;
    void lower(double to, LimitReason why);
  };
  void gather_memory(const memory::ShortTermMemory& memory);
  void gather_echoes(const RangeScan& scan);
  enum class Nearness : std::uint8_t { rough, exact };
  [[nodiscard]] double free_share(const std::vector<Point2>& points, const Motion& motion,
                                  double stop_m, Nearness nearness) const;
  [[nodiscard]] double allowed_share(double way_m, double speed_m_s) const;
  void limit_by_state(const Motion& motion, const Senses& senses,
                      const memory::ShortTermMemory& memory, Scale& scale);
  void limit_by_emergency(const Motion& motion, const Senses& senses, Scale& scale);
  void note_what_holds(const Motion& motion, bool touches);
  [[nodiscard]] MotorCommand accelerate(const Motion& wanted, Duration step) const;

  SafetyLimiterSettings settings_;
  RobotDescription robot_;
  Footprint footprint_;
  std::vector<Point2> remembered_;
  std::vector<Point2> echoes_;
  std::vector<Point2> held_by_;
  Motion last_;
  TimePoint last_time_{};
  bool first_ = true;
  double blocked_sign_ = 0.0;  // the way that stall or bumper forbids
  TimePoint blocked_until_{};
  bool emergency_active_ = false;
  int emergency_stops_ = 0;
};

}  // namespace striate::behaviours
