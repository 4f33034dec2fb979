#include "striate/behaviours/look_at.hpp"

#include <algorithm>
#include <cmath>

namespace striate::behaviours {
namespace {

constexpr double kLooksThere_rad = 0.05;  // by hand, 3 degrees of the 43 of the view
constexpr double kLongestTurn_s = 4.0;  // by hand: a head that does not get there is not waited for

}  // namespace

LookAt::LookAt(const Settings& settings, const RobotDescription& robot)
    : settings_(settings), max_pan_rad_(robot.max_pan_rad) {
  settings_.tilt_rad = std::clamp(settings_.tilt_rad, -robot.max_tilt_rad, robot.max_tilt_rad);
}

void LookAt::start(const memory::ShortTermMemory& memory) {
  started_ = memory.now();
  there_ = false;
  pan_rad_ = std::clamp(settings_.pan_rad, -max_pan_rad_, max_pan_rad_);
  region_ = 0;
  if (settings_.target != Target::salient) return;
  const memory::RememberedRegion* region = memory.salient().most_interesting(memory.now());
  if (region != nullptr) region_ = region->id;
}

bool LookAt::follow(const memory::ShortTermMemory& memory) {
  for (const memory::RememberedRegion& region : memory.salient().regions()) {
    if (!region.used || region.id != region_) continue;
    pan_rad_ = std::clamp(region.bearing_rad, -max_pan_rad_, max_pan_rad_);
    return true;
  }
  return false;
}

Wish LookAt::tick(const memory::ShortTermMemory& memory) {
  if (settings_.target == Target::salient && !follow(memory)) {
    return there_ ? final_wish(memory, Progress::succeeded, "looked at it until it was forgotten")
                  : failed_wish(memory, Failure::not_found, "nothing salient to look at");
  }
  const bool there = std::abs(memory.head().pan_rad - pan_rad_) < kLooksThere_rad;
  if (there && !there_) arrived_ = memory.now();
  there_ = there_ || there;
  if (there_ && to_seconds(memory.now() - arrived_) >= settings_.for_s) {
    return final_wish(memory, Progress::succeeded, "looked there");
  }
  if (!there_ && to_seconds(memory.now() - started_) > kLongestTurn_s) {
    return failed_wish(memory, Failure::head_stuck, "the head does not get there");
  }
  Wish wish = standing_wish(memory, "looks there");
  wish.pan_rad = pan_rad_;
  wish.tilt_rad = settings_.tilt_rad;
  return wish;
}

}  // namespace striate::behaviours
