#include "striate/behaviours/navigation/gaze_round.hpp"

#include <algorithm>
#include <cmath>

namespace striate::behaviours {
namespace {

constexpr int kSides = 2;                // left and right, before the salient regions
constexpr double kGazeThere_rad = 0.05;  // by hand, 3 degrees of the 43 of the view
constexpr double kLongestGaze_s = 3.0;  // by hand: a head that does not get there is not waited for

}  // namespace

GazeRound::GazeRound(double sweep_rad, double dwell_s, int regions, const RobotDescription& robot)
    : sweep_rad_(std::min(sweep_rad, robot.max_pan_rad)),
      dwell_s_(dwell_s),
      regions_(regions),
      max_pan_rad_(robot.max_pan_rad) {}

void GazeRound::start(const memory::ShortTermMemory& memory) {
  step_ = -1;
  aim_at_next(memory);
}

bool GazeRound::aim_at_next(const memory::ShortTermMemory& memory) {
  ++step_;
  there_ = false;
  aimed_ = memory.now();
  region_ = 0;
  if (step_ < kSides) {
    pan_rad_ = step_ == 0 ? sweep_rad_ : -sweep_rad_;
    return true;
  }
  if (step_ >= kSides + regions_) return false;
  const memory::RememberedRegion* region = memory.salient().most_interesting(memory.now());
  if (region == nullptr) {
    step_ = kSides + regions_;
    return false;
  }
  region_ = region->id;
  follow_region(memory);
  return true;
}

void GazeRound::follow_region(const memory::ShortTermMemory& memory) {
  for (const memory::RememberedRegion& region : memory.salient().regions()) {
    if (!region.used || region.id != region_) continue;
    pan_rad_ = std::clamp(region.bearing_rad, -max_pan_rad_, max_pan_rad_);
  }
}

bool GazeRound::tick(const memory::ShortTermMemory& memory, Wish& wish) {
  if (step_ >= kSides + regions_) return false;
  if (region_ != 0) follow_region(memory);
  const bool there = std::abs(memory.head().pan_rad - pan_rad_) < kGazeThere_rad;
  if (there && !there_) arrived_ = memory.now();
  there_ = there_ || there;
  const bool seen = there_ && to_seconds(memory.now() - arrived_) >= dwell_s_;
  if (seen || to_seconds(memory.now() - aimed_) > kLongestGaze_s + dwell_s_) {
    if (!aim_at_next(memory)) return false;
  }
  wish.pan_rad = pan_rad_;
  return true;
}

}  // namespace striate::behaviours
