#pragma once

#include <optional>
#include <string>

#include "striate/platform/remote/command_lease.hpp"
#include "striate/platform/remote/gap_watch.hpp"
#include "striate/platform/remote/inbox.hpp"
#include "striate/platform/remote/motion_echo.hpp"

namespace striate::remote {

/// The last gate before a robot that is led by messages. A command passes while images and
/// odometry, and a laser that has spoken, are fresh, it is no older than `lease`, what it was
/// decided by is no older than `seen_old`, and the robot follows. Where the program did not run,
/// nobody decided in the midst of motion or the line broke, it holds until `reset`. Pure.
class CommandGate {
 public:
  explicit CommandGate(const RemoteSettings& settings);

  void command(const MotorCommand& command, TimePoint now);
  /// Nothing drives any more, until the next command.
  void end(TimePoint now);
  /// The newest image that was handed out.
  void seen(TimePoint stamp) { seen_at_ = stamp; }
  /// The line to the robot broke: in the midst of a drive it holds until somebody has looked.
  void line_broke() { line_broke_ = drives_; }

  /// What the robot is to be told, twice a cycle or more; nothing before the first command. Told is
  /// a stand while anything holds. @param line why nothing can be said at all, or ""
  [[nodiscard]] std::optional<MotorCommand> tell(const Inbox& inbox, const std::string& line,
                                                 TimePoint now);
  /// The command as it was given, while it is fresh: where the head is to look, whatever holds.
  [[nodiscard]] std::optional<MotorCommand> fresh(TimePoint now) const { return lease_.at(now); }
  /// Why a stand is told in spite of a command; "" where it drives.
  [[nodiscard]] std::string hold_reason(const Inbox& inbox, const std::string& line,
                                        TimePoint now) const;
  /// Something was sent: from now on silence would not be a stop.
  [[nodiscard]] bool drives() const { return drives_; }
  [[nodiscard]] bool waits_for_reset() const {
    return gaps_.holds() || echo_.holds() || line_broke_;
  }
  /// Somebody has looked at the robot.
  void reset();

 private:
  RemoteSettings settings_;
  CommandLease lease_;
  GapWatch gaps_;
  MotionEcho echo_;
  std::optional<TimePoint> seen_at_;
  bool drives_ = false;
  bool line_broke_ = false;
};

}  // namespace striate::remote
