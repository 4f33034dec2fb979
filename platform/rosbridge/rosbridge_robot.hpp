#pragma once

#include <functional>
#include <memory>
#include <string>

#include "striate/platform/interface/robot.hpp"
#include "striate/platform/rosbridge/bridge_settings.hpp"

namespace striate::remote {
class ZeroKeeper;
}

namespace striate::rosbridge {

/// A stereo camera that is no topic of the robot's: one of this machine, for instance. Called in
/// the client's thread, which it must not hold up.
struct OwnCamera {
  std::function<StereoFrame()> newest;  ///< stamped by the robot's clock
  std::function<std::string()> trouble;
};
/// @param clock the robot's; outlives the camera
using MakeCamera = std::function<OwnCamera(const Clock& clock)>;

/// A robot that is reached through a rosbridge server, as a body: images, odometry and a laser come
/// as topics, `cmd_vel` goes out, all as JSON over a WebSocket; ROS need not be on this machine.
///
/// Its own gate is the last: see remote::CommandGate. Zero is published, too, while the server has
/// not answered for a second, and after a line that broke in the midst of a drive until `reset`.
/// With the end of the object zero is published, then the line is closed. When the program dies or
/// hangs, a process of its own says zero, see twist_keeper.hpp.
class RosbridgeRobot final : public Robot {
 public:
  /// Connects and waits for the first images and odometry.
  /// @param camera empty: images come as topics
  /// @throws UserError for settings that cannot be, std::runtime_error that says who does not
  /// answer, or on which topic nothing came
  explicit RosbridgeRobot(const BridgeSettings& settings, const RobotDescription& description = {},
                          const MakeCamera& camera = {},
                          Duration patience = std::chrono::seconds(10));
  ~RosbridgeRobot() override;

  [[nodiscard]] const RobotDescription& description() const override;
  [[nodiscard]] const Clock& clock() const override;
  /// @throws std::runtime_error when images, odometry or the server are silent for longer than
  /// `lost`.
  bool sense(Senses& senses) override;
  void send(const MotorCommand& command) override;
  void stop() noexcept override;

  /// Why zero is published in spite of a command; "" where the command drives.
  [[nodiscard]] std::string hold() const;
  [[nodiscard]] bool waits_for_reset() const;
  /// Somebody has looked at the robot.
  void reset();

 private:
  struct Parts;
  std::unique_ptr<remote::ZeroKeeper> keeper_;  // first: it must be made before there are threads
  std::unique_ptr<Parts> parts_;
};

}  // namespace striate::rosbridge
