#include "behaviours/straight_line.hpp"

#include <algorithm>
#include <cmath>

namespace striate {
namespace {

constexpr double kArrived_m = 0.01;
constexpr double kBlockedAfter_s = 5.0;
constexpr double kEasing_m_s2 = 0.3;

}  // namespace

void StraightLine::start(const ShortTermMemory& memory) {
  from_ = memory.pose();
  farthest_m_ = 0.0;
  farthest_at_ = memory.now();
}

Wish StraightLine::tick(const ShortTermMemory& memory) {
  const Pose2 moved = to_inner(from_, memory.pose());
  const double sign = speed_m_s_ < 0.0 ? -1.0 : 1.0;
  const double made_m = sign * moved.x_m;
  const double left_m = distance_m_ - made_m;
  if (left_m <= kArrived_m) return final_wish(memory, Progress::succeeded, "the way is made");
  if (made_m > farthest_m_ + 0.02) {
    farthest_m_ = made_m;
    farthest_at_ = memory.now();
  }
  if (to_seconds(memory.now() - farthest_at_) > kBlockedAfter_s) {
    return final_wish(memory, Progress::failed, "something is in the way");
  }
  Wish wish = standing_wish(memory, sign > 0.0 ? "drives straight" : "backs up");
  const double eased = std::max(0.04, std::sqrt(2.0 * kEasing_m_s2 * left_m) - 0.05);
  wish.forward_m_s = sign * std::min(std::abs(speed_m_s_), eased);
  const double aside = sign * moved.y_m;  // steer back onto the line, also when driving back
  wish.turn_rad_s = std::clamp(-1.5 * moved.heading_rad - 1.0 * aside, -0.5, 0.5);
  if (to_seconds(memory.now() - farthest_at_) > 2.0) wish.why = "waits: something is in the way";
  return wish;
}

}  // namespace striate
