#include "striate/viewer/foxglove/remote_pilot.hpp"

#include <cmath>

#include "striate/base/limits.hpp"

namespace striate::viewer::foxglove {

bool RemotePilot::is_young(const Command& command) const {
  return clock_.now() - command.sent_after <= kCommandLease;
}

RemotePilot::Taken RemotePilot::command(std::uint64_t client, const WantedMotion& motion,
                                        TimePoint sent_after) {
  const std::lock_guard lock(mutex_);
  Command command{client, motion, sent_after, std::nullopt};
  if (!is_young(command)) return Taken::too_old;
  if (paused_) return Taken::paused;
  if (command_ && command_->client != client && is_young(*command_)) return Taken::another_drives;
  if (!std::isfinite(motion.forward_m_s) || !std::isfinite(motion.turn_rad_s)) command.motion = {};
  command_ = command;
  return Taken::taken;
}

void RemotePilot::leave(std::uint64_t client) {
  const std::lock_guard lock(mutex_);
  if (command_ && command_->client == client) command_.reset();
}

void RemotePilot::pause() {
  const std::lock_guard lock(mutex_);
  paused_ = true;
  command_.reset();  // it does not go on where the pause ends
}

void RemotePilot::resume() {
  const std::lock_guard lock(mutex_);
  paused_ = false;
}

bool RemotePilot::paused() const {
  const std::lock_guard lock(mutex_);
  return paused_;
}

std::optional<behaviours::Wish> RemotePilot::wish(TimePoint now) {
  const std::lock_guard lock(mutex_);
  behaviours::Wish wish;
  wish.tilt_rad = resting_tilt_rad_;
  wish.stamp = now;
  if (paused_) {
    wish.why = "paused from a viewer";
    return wish;
  }
  if (!command_) return std::nullopt;
  if (!command_->heard_at) command_->heard_at = now;
  if (!is_young(*command_) || now - *command_->heard_at > kCommandLease) {
    command_.reset();
    return std::nullopt;
  }
  wish.forward_m_s = command_->motion.forward_m_s;
  wish.turn_rad_s = command_->motion.turn_rad_s;
  wish.why = "cmd_vel of a viewer drives";
  return wish;
}

}  // namespace striate::viewer::foxglove
