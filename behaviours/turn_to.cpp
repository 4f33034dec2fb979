#include "striate/behaviours/turn_to.hpp"

#include <algorithm>
#include <cmath>

namespace striate::behaviours {
namespace {

// "By hand": README.md, "Where the numbers come from"; the tests are TurnTo.*.

constexpr double kArrived_rad = 0.03;    // by hand, 1.7 degrees
constexpr double kStands_rad_s = 0.1;    // by hand: faster than this it would turn past
constexpr double kNearer_rad = 0.03;     // by hand, as much as an arrival
constexpr double kBlockedAfter_s = 5.0;  // by hand: no nearer for so long
// By hand: eased with 40 % of the body's turn acceleration, to a speed below it by about what a
// cycle takes off (0.08 rad/s), but no slower than the last.
constexpr double kEasing_rad_s2 = 0.8;
constexpr double kEasedBelow_rad_s = 0.1;
constexpr double kLeast_rad_s = 0.06;
constexpr double kMostPan_rad = 0.8;  // by hand: the head goes before, a view's width at most

}  // namespace

TurnTo::TurnTo(const Settings& settings, const RobotDescription& robot) : settings_(settings) {
  settings_.rate_rad_s = std::min(settings_.rate_rad_s, robot.max_turn_rad_s);
}

void TurnTo::start(const memory::ShortTermMemory& memory) {
  last_heading_rad_ = memory.pose().heading_rad;
  const double target_rad = memory.corridor().axis_rad() + settings_.heading_rad;
  left_rad_ =
      settings_.by_rad != 0.0 ? settings_.by_rad : wrap_angle(target_rad - last_heading_rad_);
  least_left_rad_ = std::abs(left_rad_);
  least_left_at_ = memory.now();
}

Wish TurnTo::tick(const memory::ShortTermMemory& memory) {
  left_rad_ -= wrap_angle(memory.pose().heading_rad - last_heading_rad_);
  last_heading_rad_ = memory.pose().heading_rad;
  const double far_rad = std::abs(left_rad_);
  if (far_rad < kArrived_rad && std::abs(memory.turn_rad_s()) < kStands_rad_s) {
    return final_wish(memory, Progress::succeeded, "turned");
  }
  if (far_rad < least_left_rad_ - kNearer_rad) {
    least_left_rad_ = far_rad;
    least_left_at_ = memory.now();
  }
  if (to_seconds(memory.now() - least_left_at_) > kBlockedAfter_s) {
    return failed_wish(memory, Failure::cannot_turn, "cannot turn here");
  }
  Wish wish = standing_wish(memory, "turns");
  const double eased =
      std::max(kLeast_rad_s, std::sqrt(2.0 * kEasing_rad_s2 * far_rad) - kEasedBelow_rad_s);
  if (far_rad >= kArrived_rad) {
    wish.turn_rad_s = std::copysign(std::min(settings_.rate_rad_s, eased), left_rad_);
  }
  // The head looks where the robot will face.
  wish.pan_rad = std::clamp(left_rad_, -kMostPan_rad, kMostPan_rad);
  return wish;
}

}  // namespace striate::behaviours
