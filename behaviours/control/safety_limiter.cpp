#include "striate/behaviours/control/safety_limiter.hpp"

#include <algorithm>
#include <cmath>

#include "striate/base/stopping_speed.hpp"

namespace striate::behaviours {
namespace {

// To stop from 0.75 m/s takes 0.68 m (0.5 m/s2 after 0.15 s), the outline reaches 0.37 m from the
// axle and stands 0.06 m off: 1.1 m, and some room.
constexpr double kSight_m = 1.4;
constexpr double kStep_s = 0.05;     // at 0.75 m/s 0.04 m, less than a patch of the map
constexpr double kHorizon_s = 2.0;   // to stop from 0.75 m/s takes 1.65 s
constexpr double kInside_m = -0.02;  // half a patch: what is farther inside is an error of the map
// By hand (README.md, "Where the numbers come from"): nearer by this much is towards, not along;
// less than a tenth of a patch.
constexpr double kDeeper_m = 0.004;
constexpr double kExact_m = 1e-6;    // the rounding of metres, no distance
constexpr double kFirstSteps = 1.5;  // of kStep_s: the first step and not the second
// By hand: slower motion touches nothing; turning, the farthest corner then makes 0.02 m/s.
constexpr double kMoves_m_s = 0.01;
constexpr double kTurns_rad_s = 0.05;
constexpr double kStopsBelow = 0.05;    // by hand: share of the speed that is called a stop
constexpr double kOldImageLeast = 0.2;  // by hand: share of the speed, until it is too old
constexpr double kSteppedIn = 0.5;  // by hand: took more than half of the speed, as README.md says
// By hand: what holds the robot is nearer than it is slowed for at a creep, and comes nearer by
// more than a laser's noise in a look ahead of so long.
constexpr double kHolds_m = 0.30;
constexpr double kHoldsLook_s = 0.3;
// What is touched may be anywhere along the bumper: points a patch of the map apart, a patch off.
constexpr double kTouches_m = 0.05;
constexpr double kLongestStep_s = 0.5;  // by hand, five cycles: after a pause no leap of speed

double outer_speed(double forward_m_s, double turn_rad_s, double radius_m) {
  return std::abs(forward_m_s) + std::abs(turn_rad_s) * radius_m;
}

}  // namespace

SafetyLimiter::SafetyLimiter(const SafetyLimiterSettings& settings, const RobotDescription& robot)
    : settings_(settings), robot_(robot), footprint_(robot) {
  remembered_.reserve(4096);
  echoes_.reserve(1024);
  held_by_.reserve(1024);
}

void SafetyLimiter::Scale::lower(double to, LimitReason why) {
  if (to >= factor) return;
  factor = std::max(0.0, to);
  reason = why;
}

void SafetyLimiter::gather_memory(const memory::ShortTermMemory& memory) {
  remembered_.clear();
  const memory::LocalGrid& grid = memory.map();
  const int reach = static_cast<int>(kSight_m / memory::LocalGrid::kCell_m);
  const memory::GridCell middle =
      memory::LocalGrid::cell_of({memory.pose().x_m, memory.pose().y_m});
  for (int y = middle.y - reach; y <= middle.y + reach; ++y) {
    for (int x = middle.x - reach; x <= middle.x + reach; ++x) {
      if (!grid.stands({x, y})) continue;
      if (remembered_.size() == remembered_.capacity()) return;
      remembered_.push_back(inverse_transform(memory.pose(), memory::LocalGrid::centre_of({x, y})));
    }
  }
}

void SafetyLimiter::gather_echoes(const RangeScan& scan) {
  for (const RangeReading& echo : scan.readings) {
    if (!(echo.distance_m < kSight_m) || echoes_.size() == echoes_.capacity()) continue;
    echoes_.push_back({echo.distance_m * std::cos(echo.bearing_rad),
                       echo.distance_m * std::sin(echo.bearing_rad)});
  }
}

// How much of the speed still stops in time before a thing that is `way_m` of travel away.
double SafetyLimiter::allowed_share(double way_m, double speed_m_s) const {
  if (way_m <= 0.0) return 0.0;
  const double allowed = stopping_speed(way_m, robot_.max_acceleration_m_s2, settings_.latency_s);
  const double zoned = way_m < settings_.slow_m ? std::min(allowed, settings_.slow_m_s) : allowed;
  return zoned / speed_m_s;
}

// Rolls the motion on and finds the first moment in which a point comes nearer to the outline
// than `stop_m` and nearer than it is now.
double SafetyLimiter::free_share(const std::vector<Point2>& points, const Motion& motion,
                                 double stop_m, Nearness nearness) const {
  const double radius_m = std::hypot(robot_.rear_m, robot_.half_width_m);
  const double speed = outer_speed(motion.forward_m_s, motion.turn_rad_s, radius_m);
  if (speed < kMoves_m_s) return 1.0;
  double first_s = kHorizon_s;
  for (const Point2& point : points) {
    const double now_m = footprint_.distance_m(point);
    if (now_m < kInside_m) continue;  // inside the robot: an error of the map, not a thing
    if (now_m - speed * first_s > stop_m) continue;
    // A patch of the map is 5 cm wide, so a little nearer to it means nothing. An echo is a point:
    // the little would be taken anew in every cycle, and end in a touch. For the same reason the
    // first step is looked at for every echo, whatever was found of the others.
    const bool exact = nearness == Nearness::exact;
    const double left = std::clamp(now_m / std::max(stop_m, kExact_m), 0.0, 1.0);
    const double deeper_m = exact ? kDeeper_m * left + kExact_m : kDeeper_m;
    const double until_s = exact ? std::max(first_s, kFirstSteps * kStep_s) : first_s;
    for (double t = kStep_s; t < until_s; t += kStep_s) {
      const Pose2 pose = along_arc({}, motion.forward_m_s, motion.turn_rad_s, t);
      const double then_m = footprint_.distance_m(inverse_transform(pose, point));
      if (then_m < stop_m && then_m < now_m - deeper_m) {
        first_s = t - kStep_s;
        break;
      }
    }
  }
  return first_s >= kHorizon_s - 1e-9 ? 1.0 : allowed_share(speed * first_s, speed);
}

void SafetyLimiter::limit_by_state(const Motion& motion, const Senses& senses,
                                   const memory::ShortTermMemory& memory, Scale& scale) {
  gather_memory(memory);
  const double share = free_share(remembered_, motion, settings_.stop_m, Nearness::rough);
  scale.lower(share, share < kStopsBelow ? LimitReason::memory_stop : LimitReason::slow_zone);

  const double age_s = memory.image_age_s();
  if (age_s > settings_.image_slow_s) {
    const double span_s = std::max(1e-3, settings_.image_stop_s - settings_.image_slow_s);
    const double fresh = age_s > settings_.image_stop_s
                             ? 0.0
                             : std::max(kOldImageLeast, (settings_.image_stop_s - age_s) / span_s);
    scale.lower(fresh, LimitReason::image_old);
  }
  // A body without a gauge says 0 V.
  if (senses.battery_v > 0.0 && senses.battery_v < settings_.battery_slow_v) {
    const double slow = settings_.battery_slow_m_s / std::max(0.01, std::abs(motion.forward_m_s));
    scale.lower(senses.battery_v < settings_.battery_stop_v ? 0.0 : slow, LimitReason::battery_low);
  }
}

void SafetyLimiter::limit_by_emergency(const Motion& motion, const Senses& senses, Scale& scale) {
  Scale emergency = scale;
  if (settings_.emergency_layer) {
    echoes_.clear();
    gather_echoes(senses.sonar);
    gather_echoes(senses.laser);
    emergency.lower(free_share(echoes_, motion, settings_.emergency_stop_m, Nearness::exact),
                    LimitReason::emergency_range);
  }
  if (senses.bumper || senses.motors_stalled) {
    if (blocked_sign_ == 0.0 || senses.now >= blocked_until_) {
      blocked_sign_ = last_.forward_m_s < 0.0 ? -1.0 : 1.0;
    }
    blocked_until_ = senses.now + from_seconds(settings_.stall_pause_s);
  }
  // Touching: only the way back, and no turning that would sweep along the thing.
  if (senses.now < blocked_until_ && motion.forward_m_s * blocked_sign_ >= 0.0) {
    emergency.lower(0.0, senses.bumper ? LimitReason::bumper : LimitReason::stalled);
  }
  const bool moves =
      std::abs(motion.forward_m_s) > kMoves_m_s || std::abs(motion.turn_rad_s) > kTurns_rad_s;
  const bool holds = moves && emergency.factor < kSteppedIn * scale.factor;
  const bool active = holds && emergency.reason != LimitReason::stalled;
  if (active && !emergency_active_) ++emergency_stops_;
  emergency_active_ = active;
  if (holds) note_what_holds(motion, emergency.reason != LimitReason::emergency_range);
  scale = emergency;
}

/// The echoes that the motion leads to; of a touch, all of the end that leads.
void SafetyLimiter::note_what_holds(const Motion& motion, bool touches) {
  if (touches) {
    const double end_m =
        motion.forward_m_s < 0.0 ? -robot_.rear_m - kTouches_m : robot_.front_m + kTouches_m;
    for (double y = -robot_.half_width_m; y <= robot_.half_width_m; y += kTouches_m) {
      held_by_.push_back({end_m, y});
    }
    return;
  }
  const Pose2 soon = along_arc({}, motion.forward_m_s, motion.turn_rad_s, kHoldsLook_s);
  for (const Point2& echo : echoes_) {
    const double now_m = footprint_.distance_m(echo);
    if (now_m > kHolds_m || now_m < kInside_m) continue;
    if (footprint_.distance_m(inverse_transform(soon, echo)) < now_m - kDeeper_m) {
      held_by_.push_back(echo);
    }
  }
}

MotorCommand SafetyLimiter::accelerate(const Motion& wanted, Duration step) const {
  const double step_s = std::clamp(to_seconds(step), 0.0, kLongestStep_s);
  const auto ease = [step_s](double from, double to, double limit) {
    // Braking is never delayed; only growing speed is.
    const bool brakes = std::abs(to) <= std::abs(from) && from * to >= 0.0;
    if (brakes) return to;
    const double base = from * to < 0.0 ? 0.0 : from;
    return base + std::clamp(to - base, -limit * step_s, limit * step_s);
  };
  MotorCommand command;
  command.forward_m_s = ease(last_.forward_m_s, wanted.forward_m_s, robot_.max_acceleration_m_s2);
  command.turn_rad_s =
      ease(last_.turn_rad_s, wanted.turn_rad_s, robot_.max_turn_acceleration_rad_s2);
  return command;
}

Limited SafetyLimiter::limit(const Wish& wish, const Senses& senses,
                             const memory::ShortTermMemory& memory) {
  const auto sane = [](double value, double most) {
    return std::isfinite(value) ? std::clamp(value, -most, most) : 0.0;
  };
  const Motion wanted{sane(wish.forward_m_s, robot_.max_forward_m_s),
                      sane(wish.turn_rad_s, robot_.max_turn_rad_s)};
  held_by_.clear();
  Scale scale;
  limit_by_state(wanted, senses, memory, scale);
  if (to_seconds(senses.now - wish.stamp) > settings_.lease_s) {
    scale.lower(0.0, LimitReason::wish_old);
  }
  limit_by_emergency(wanted, senses, scale);
  // One factor for both keeps the arc: it was this arc that was found free.
  const Motion allowed{wanted.forward_m_s * scale.factor, wanted.turn_rad_s * scale.factor};
  const Duration step = first_ ? robot_.cycle : senses.now - last_time_;
  MotorCommand command = accelerate(allowed, step);
  command.pan_rad = sane(wish.pan_rad, robot_.max_pan_rad);
  command.tilt_rad = sane(wish.tilt_rad, robot_.max_tilt_rad);
  const bool gathers_speed = std::abs(command.forward_m_s - allowed.forward_m_s) > 1e-9 ||
                             std::abs(command.turn_rad_s - allowed.turn_rad_s) > 1e-9;
  last_ = {command.forward_m_s, command.turn_rad_s};
  last_time_ = senses.now;
  first_ = false;
  const bool only_that = gathers_speed && scale.reason == LimitReason::none;
  return {command, only_that ? LimitReason::acceleration : scale.reason, held_by_};
}

const char* name_of(LimitReason reason) {
  switch (reason) {
    case LimitReason::acceleration:
      return "gathers speed";
    case LimitReason::battery_low:
      return "battery low";
    case LimitReason::slow_zone:
      return "near something";
    case LimitReason::memory_stop:
      return "something remembered is in the way";
    case LimitReason::image_old:
      return "the newest image is old";
    case LimitReason::wish_old:
      return "the wish is old";
    case LimitReason::stalled:
      return "motors stalled";
    case LimitReason::emergency_range:
      return "sonar or laser";
    case LimitReason::bumper:
      return "bumper";
    case LimitReason::none:
      break;
  }
  return "";
}

}  // namespace striate::behaviours
