#pragma once

#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "striate/agent/mission.hpp"
#include "striate/platform/replay/replay_robot.hpp"

namespace striate::agent {

/// What a recording is run again with.
struct ReplayOptions {
  std::string recording;
  std::string robot;  ///< other settings; empty: those of the recording
  std::string task;   ///< another task; empty: that of the recording
};

/// A recorded run once more: the whole robot on what it felt then. Its decisions have no effect on
/// what it feels.
class ReplayMission {
 public:
  /// @throws UserError for a file that is none, and with all mistakes of another task or settings
  explicit ReplayMission(const ReplayOptions& options);

  /// One cycle; false at the end. @throws UserError where the file is damaged.
  bool step();

  /// What was decided otherwise in the cycle of the last step; empty: nothing, bit for bit.
  [[nodiscard]] std::vector<std::string> differences() const;
  [[nodiscard]] const replay::RecordedCycle& recorded() const { return body_->cycle(); }
  [[nodiscard]] const CognitiveCycle& cycle() const { return mission_->cycle(); }
  [[nodiscard]] const tasks::Executive& executive() const { return mission_->executive(); }
  [[nodiscard]] const RobotSettings& settings() const { return mission_->settings(); }
  [[nodiscard]] const RobotDescription& robot() const { return body_->description(); }
  [[nodiscard]] const replay::RecordedSetup& setup() const { return reader_.setup(); }
  [[nodiscard]] replay::Ending ending() const { return reader_.ending(); }
  /// Settings that are not as they were recorded: "memory.free_fades 30 s (then 20 s)".
  [[nodiscard]] std::vector<std::string> changed_settings() const;
  /// Where the robot believed to be (odometry frame), oldest first.
  [[nodiscard]] const std::deque<Point2>& trajectory() const { return mission_->trajectory(); }

 private:
  replay::RecordingReader reader_;
  replay::ReplayRobot* body_ = nullptr;  ///< the mission's
  std::optional<Mission> mission_;
};

}  // namespace striate::agent
