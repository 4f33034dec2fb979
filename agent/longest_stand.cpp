#include "striate/agent/longest_stand.hpp"

#include <cmath>

namespace striate::agent {
namespace {

/// Ten times the resolution of a SIP's wheel speeds, as the driver's
constexpr double kStands_m_s = 0.01;
/// 1.1 deg/s: ten times the resolution of a SIP's turning speed, as the driver's
constexpr double kStands_rad_s = 0.02;

bool stands(const Odometry& odometry) {
  return std::abs(odometry.forward_m_s) < kStands_m_s &&
         std::abs(odometry.turn_rad_s) < kStands_rad_s;
}

}  // namespace

void LongestStand::look(const CycleTrace& trace) {
  if (!stands(trace.senses.odometry)) stands_since_ = trace.senses.now;
  const double time_s = to_seconds(trace.senses.now - stands_since_);
  if (time_s <= longest_s_) return;
  longest_s_ = time_s;
  why_ = trace.wish.why;
  limit_ = trace.limited_by;
}

std::string LongestStand::why() const {
  return doing_text(why_, limit_);
}

}  // namespace striate::agent
