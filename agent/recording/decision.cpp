#include "striate/agent/recording/decision.hpp"

#include <fmt/format.h>

#include <bit>
#include <cstdint>

namespace striate::agent {
namespace {

/// Not `==`: minus zero is not zero, and a NaN is itself.
bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

/// The shortest digits that tell two doubles apart.
void compare(const char* what, const char* unit, double now, double then,
             std::vector<std::string>& list) {
  if (!same_bits(now, then))
    list.push_back(fmt::format("{} {} {} (then {})", what, now, unit, then));
}

void compare(const char* what, const std::string& now, const std::string& then,
             std::vector<std::string>& list) {
  if (now != then) list.push_back(fmt::format("{} '{}' (then '{}')", what, now, then));
}

void compare(const std::string& what, const MotorCommand& now, const MotorCommand& then,
             std::vector<std::string>& list) {
  compare((what + " forward").c_str(), "m/s", now.forward_m_s, then.forward_m_s, list);
  compare((what + " turn").c_str(), "rad/s", now.turn_rad_s, then.turn_rad_s, list);
  compare((what + " pan").c_str(), "rad", now.pan_rad, then.pan_rad, list);
  compare((what + " tilt").c_str(), "rad", now.tilt_rad, then.tilt_rad, list);
}

}  // namespace

void note_decision(const CycleTrace& trace, const tasks::Executive& executive,
                   replay::RecordedDecision& decision) {
  const behaviours::Wish& wish = trace.wish;
  decision.wish = {wish.forward_m_s, wish.turn_rad_s, wish.pan_rad, wish.tilt_rad};
  decision.progress = static_cast<int>(wish.progress);
  decision.wish_stamp = wish.stamp;
  decision.why = wish.why.view();
  decision.sent = trace.sent;
  decision.limited_by = name_of(trace.limited_by);
  decision.doing = executive.current_action();
}

std::vector<std::string> differences(const replay::RecordedDecision& now,
                                     const replay::RecordedDecision& then) {
  std::vector<std::string> list;
  compare("sent", now.sent, then.sent, list);
  compare("wish", now.wish, then.wish, list);
  compare("action", now.doing, then.doing, list);
  compare("why", now.why, then.why, list);
  compare("limited by", now.limited_by, then.limited_by, list);
  if (now.progress != then.progress) {
    list.push_back(fmt::format("progress {} (then {})", now.progress, then.progress));
  }
  compare("stamp of the wish", "s", to_seconds(now.wish_stamp), to_seconds(then.wish_stamp), list);
  return list;
}

}  // namespace striate::agent
