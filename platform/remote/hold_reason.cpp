#include "striate/platform/remote/hold_reason.hpp"

#include <cstdio>

namespace striate::remote {
namespace {

std::string old(const char* what, Duration age) {
  char text[96];
  std::snprintf(text, sizeof(text), "%s %.1f s old: late on the way, or the clocks differ", what,
                to_seconds(age));
  return text;
}

}  // namespace

std::string stale_sense(const Inbox& inbox, Duration stale, TimePoint now) {
  const auto silent = [&](const std::optional<TimePoint>& came) {
    return !came || now - *came > stale;
  };
  const Senses& senses = inbox.senses();
  if (silent(inbox.odometry_came())) return "no odometry";
  if (silent(inbox.images_came())) return "no images";
  if (now - senses.odometry.stamp > stale) return old("odometry is", now - senses.odometry.stamp);
  if (now - senses.stereo.stamp > stale) return old("images are", now - senses.stereo.stamp);
  if (!inbox.laser_came()) return {};
  if (silent(inbox.laser_came())) return "the laser is silent";
  if (now - senses.laser.stamp > stale) return old("the laser is", now - senses.laser.stamp);
  return {};
}

}  // namespace striate::remote
