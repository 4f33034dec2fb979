#pragma once

#include <cstdint>
#include <mutex>
#include <optional>

#include "striate/base/time.hpp"
#include "striate/behaviours/control/wish.hpp"
#include "striate/viewer/foxglove/twist_reader.hpp"

namespace striate::viewer::foxglove {

/// Somebody who drives from a viewer, or has paused the robot. A command drives for kCommandLease
/// from the moment after which it was surely sent, on the machine's clock; and as long from the
/// cycle that first heard of it, on the mission's: a simulated one may be faster. One client drives
/// at a time. What it wants still has to pass the safety limiter.
class RemotePilot {
 public:
  /// @param clock of the machine; must live as long. @param resting_tilt_rad where the head looks
  RemotePilot(const Clock& clock, double resting_tilt_rad)
      : clock_(clock), resting_tilt_rad_(resting_tilt_rad) {}

  enum class Taken : std::uint8_t { taken, too_old, another_drives, paused };
  /// A speed that is no number is a stop. @param sent_after of the machine's clock
  Taken command(std::uint64_t client, const WantedMotion& motion, TimePoint sent_after);
  /// The client is gone.
  void leave(std::uint64_t client);
  void pause();
  void resume();
  [[nodiscard]] bool paused() const;

  /// What it wants in this cycle; nothing: the task drives. @param now of the mission's clock
  [[nodiscard]] std::optional<behaviours::Wish> wish(TimePoint now);

 private:
  struct Command {
    std::uint64_t client = 0;
    WantedMotion motion;
    TimePoint sent_after;               ///< the machine's clock
    std::optional<TimePoint> heard_at;  ///< the mission's clock
  };
  [[nodiscard]] bool is_young(const Command& command) const;

  const Clock& clock_;
  double resting_tilt_rad_;
  mutable std::mutex mutex_;  ///< guards what follows
  std::optional<Command> command_;
  bool paused_ = false;
};

}  // namespace striate::viewer::foxglove
