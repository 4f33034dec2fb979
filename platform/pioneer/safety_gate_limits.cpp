#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "striate/base/stopping_speed.hpp"
#include "striate/platform/pioneer/keeper/line_keeper.hpp"
#include "striate/platform/pioneer/safety_gate.hpp"

namespace striate::pioneer {
namespace {

/// The head's thread speaks every few milliseconds.
constexpr Duration kHeadSilent = std::chrono::milliseconds(500);
/// Those that look within 30 deg of straight ahead (robot_model.cpp)
constexpr std::array<std::size_t, 4> kFrontDiscs{2, 3, 4, 5};
/// Those that look within 30 deg of straight behind (robot_model.cpp)
constexpr std::array<std::size_t, 4> kRearDiscs{10, 11, 12, 13};
/// Of the brake that the gate counts on; less where the robot was told less.
constexpr double kMostBrakeMm_s2 = 300.0;

}  // namespace

double SafetyGate::free_way_mm_s(bool forward, TimePoint now) const {
  double nearest_m = std::numeric_limits<double>::infinity();
  for (const std::size_t disc : forward ? kFrontDiscs : kRearDiscs) {
    const DiscReading& reading = session_.base().sonar[disc];
    if (reading.told && now - reading.stamp < kSonarFresh) {
      nearest_m = std::min(nearest_m, reading.range_m);
    }
  }
  const double way_mm = 1000.0 * std::max(0.0, nearest_m - settings_.sonar_stop_m);
  if (!std::isfinite(way_mm)) return way_mm;
  const double brake = std::min(kMostBrakeMm_s2, session_.deceleration_mm_s2());
  return stopping_speed(way_mm, brake, settings_.latency_s);
}

void SafetyGate::limit_by_sonar(Motion& motion, TimePoint now) {
  if (!settings_.sonar || motion.forward_mm_s == 0.0) return;
  const double most = free_way_mm_s(motion.forward_mm_s > 0.0, now);
  if (most >= std::abs(motion.forward_mm_s)) return;
  reason_ = most < kCreepsMm_s ? HoldReason::obstacle : HoldReason::slowed;
  motion.forward_mm_s = most < kCreepsMm_s ? 0.0 : std::copysign(most, motion.forward_mm_s);
}

void SafetyGate::limit_by_touch(Motion& motion, TimePoint now) {
  const BaseState& base = session_.base();
  if ((base.stalled_left || base.stalled_right) && sent_forward_mm_s_ != 0) {
    blocked_sign_ = sent_forward_mm_s_ > 0 ? 1.0 : -1.0;
    blocked_until_ = now + from_seconds(settings_.stall_pause_s);
  }
  if (now < blocked_until_ && motion.forward_mm_s * blocked_sign_ > 0.0) {
    motion = {};
    reason_ = HoldReason::stalled;
  }
  if ((base.bumper_front && motion.forward_mm_s > 0.0) ||
      (base.bumper_rear && motion.forward_mm_s < 0.0)) {
    motion = {};
    reason_ = HoldReason::bumper;
  }
}

bool SafetyGate::line_is_late(TimePoint now) const {
  const bool unknown = session_.measures_the_line() && !session_.line_delay(now);
  return unknown || now < line_late_until_;
}

bool SafetyGate::laser_is_stale(TimePoint now) const {
  const Duration longest = from_seconds(settings_.laser_stale_s);
  const RangeScan& laser = session_.base().laser;
  if (!laser.readings.empty() && now - laser.stamp > longest) return true;
  return laser_at_ && now - *laser_at_ > longest;
}

bool SafetyGate::head_fails(TimePoint now) const {
  return !head_ok_ || (head_told_at_ && now - *head_told_at_ > kHeadSilent);
}

SafetyGate::Motion SafetyGate::allowed(TimePoint now) {
  reason_ = HoldReason::none;
  if (latch_ != HoldReason::none) {
    reason_ = latch_;
  } else if (session_.state() != LinkState::ready) {
    reason_ = HoldReason::not_ready;
  } else if (silent_) {
    reason_ = HoldReason::robot_silent;
  } else if (!given_ || given_at_ <= not_before_) {
    reason_ = HoldReason::no_command;
  } else if (now - given_at_ > from_seconds(settings_.command_lease_s)) {
    reason_ = HoldReason::command_old;
  } else if (line_is_late(now)) {
    reason_ = HoldReason::line_late;
  } else if (now < seen_old_until_) {
    reason_ = HoldReason::seen_old;
  } else if (session_.base().battery_v < settings_.battery_stop_v) {
    reason_ = HoldReason::battery_low;
  } else if (laser_is_stale(now)) {
    reason_ = HoldReason::laser_stale;
  } else if (head_fails(now)) {
    reason_ = HoldReason::head_fails;
  }
  if (reason_ != HoldReason::none) return {};
  Motion motion{1000.0 * command_.forward_m_s, degrees(command_.turn_rad_s)};
  motion.forward_mm_s =
      std::clamp(motion.forward_mm_s, -session_.most_forward_mm_s(), session_.most_forward_mm_s());
  motion.turn_deg_s =
      std::clamp(motion.turn_deg_s, -session_.most_turn_deg_s(), session_.most_turn_deg_s());
  limit_by_sonar(motion, now);
  limit_by_touch(motion, now);
  return motion;
}

}  // namespace striate::pioneer
