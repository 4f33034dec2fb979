#include "striate/behaviours/navigation/straight_line.hpp"

#include <algorithm>
#include <cmath>

namespace striate::behaviours {
namespace {

// "By hand": README.md, "Where the numbers come from"; tests: DriveStraight.* and BackUp.*.

constexpr double kLineArrived_m = 0.01;      // by hand: a quarter of a second at the slowest
constexpr double kFarther_m = 0.02;          // by hand: twice an arrival
constexpr double kLineBlockedAfter_s = 5.0;  // by hand: no farther for so long
constexpr double kWaitsAfter_s = 2.0;        // by hand: says so before it gives up
// By hand: eased with 60 % of the body's deceleration, to a speed below it by more than a cycle
// takes off (0.03 m/s), but no slower than the last.
constexpr double kLineEasing_m_s2 = 0.3;
constexpr double kEasedBelow_m_s = 0.05;
constexpr double kLineLeast_m_s = 0.04;
// By hand, back onto the line: turn rate per radian off its direction, per metre aside, and most.
constexpr double kHeadingGain_1_s = 1.5;
constexpr double kAsideGain_rad_m_s = 1.0;
constexpr double kLineTurn_rad_s = 0.5;

}  // namespace

void StraightLine::start(const memory::ShortTermMemory& memory) {
  from_ = memory.pose();
  farthest_m_ = 0.0;
  farthest_at_ = memory.now();
}

Wish StraightLine::tick(const memory::ShortTermMemory& memory) {
  const Pose2 moved = inverse_transform(from_, memory.pose());
  const double sign = speed_m_s_ < 0.0 ? -1.0 : 1.0;
  const double made_m = sign * moved.x_m;
  const double left_m = distance_m_ - made_m;
  if (left_m <= kLineArrived_m) return final_wish(memory, Progress::succeeded, "the way is made");
  if (made_m > farthest_m_ + kFarther_m) {
    farthest_m_ = made_m;
    farthest_at_ = memory.now();
  }
  if (to_seconds(memory.now() - farthest_at_) > kLineBlockedAfter_s) {
    return failed_wish(memory, Failure::way_blocked, "something is in the way");
  }
  Wish wish = standing_wish(memory, sign > 0.0 ? "drives straight" : "backs up");
  const double eased =
      std::max(kLineLeast_m_s, std::sqrt(2.0 * kLineEasing_m_s2 * left_m) - kEasedBelow_m_s);
  wish.forward_m_s = sign * std::min(std::abs(speed_m_s_), eased);
  const double aside = sign * moved.y_m;  // steer back onto the line, also when driving back
  wish.turn_rad_s = std::clamp(-kHeadingGain_1_s * moved.heading_rad - kAsideGain_rad_m_s * aside,
                               -kLineTurn_rad_s, kLineTurn_rad_s);
  if (to_seconds(memory.now() - farthest_at_) > kWaitsAfter_s)
    wish.why = "waits: something is in the way";
  return wish;
}

}  // namespace striate::behaviours
