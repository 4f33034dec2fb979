#include "striate/behaviours/look_around.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "striate/behaviours/view_angles.hpp"

namespace striate::behaviours {
namespace {

struct Gaze {
  double pan_share;
  bool near;
};
constexpr double kNear_rad = -0.5;  // the floor is in view from 1.2 m on: 1.2 m / tan(45 degrees)
// By hand: near and far at each side, and back: the floor and what stands on it.
constexpr std::array<Gaze, 6> kGazes{Gaze{0.0, true},   Gaze{1.0, true},  Gaze{1.0, false},
                                     Gaze{-1.0, false}, Gaze{-1.0, true}, Gaze{0.0, false}};
constexpr double kThere_rad = 0.05;  // by hand, 3 degrees of the 43 of the view
constexpr double kLongest_s = 4.0;   // by hand: a head that does not get there is not waited for

}  // namespace

LookAround::LookAround(const Settings& settings, const RobotDescription& robot)
    : settings_(settings), robot_(robot) {
  settings_.pan_rad = std::min(settings_.pan_rad, robot_.max_pan_rad);
}

void LookAround::start(const memory::ShortTermMemory& memory) {
  step_ = 0;
  there_ = false;
  step_began_ = memory.now();
}

Wish LookAround::tick(const memory::ShortTermMemory& memory) {
  if (step_ >= static_cast<int>(kGazes.size())) {
    return final_wish(memory, Progress::succeeded, "looked round");
  }
  const Gaze& gaze = kGazes[static_cast<std::size_t>(step_)];
  Wish wish = standing_wish(memory, "looks round");
  wish.pan_rad = gaze.pan_share * settings_.pan_rad;
  const double tilt_rad = gaze.near ? same_floor_tilt(robot_, kNear_rad) : robot_.resting_tilt_rad;
  wish.tilt_rad = std::max(tilt_rad, -robot_.max_tilt_rad);
  const bool there = std::abs(memory.head().pan_rad - wish.pan_rad) < kThere_rad &&
                     std::abs(memory.head().tilt_rad - wish.tilt_rad) < kThere_rad;
  if (there && !there_) arrived_ = memory.now();
  there_ = there;
  const bool seen = there_ && to_seconds(memory.now() - arrived_) >= settings_.dwell_s;
  if (seen || to_seconds(memory.now() - step_began_) > kLongest_s + settings_.dwell_s) {
    ++step_;
    there_ = false;
    step_began_ = memory.now();
  }
  return wish;
}

}  // namespace striate::behaviours
