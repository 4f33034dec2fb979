#pragma once

#include <memory>
#include <string>

#include "striate/platform/interface/robot.hpp"
#include "striate/platform/ros/ros_settings.hpp"

namespace striate::ros {

/// A ROS bag as a body: the recorded images and odometry, one image pair a cycle, as fast as
/// they are asked for. Needs no master. Commands go nowhere. Topics of the settings that the bag
/// does not have are looked for by their type and name (see find_topics()).
class BagRobot final : public Robot {
 public:
  /// @param camera what the eyes' topics begin with, for bags of several stereo cameras
  /// @throws UserError where the file is no bag, has no stereo images of a known camera, or several
  /// such cameras; the message lists what topics it has.
  BagRobot(const std::string& file, const RosSettings& settings,
           const RobotDescription& description = {}, const std::string& camera = {});
  ~BagRobot() override;

  /// With the topics that are read.
  [[nodiscard]] const RosSettings& settings() const;
  [[nodiscard]] const RobotDescription& description() const override;
  /// The bag's time, from its beginning.
  [[nodiscard]] const Clock& clock() const override;
  /// Reads on to the next image pair; false at the end. @throws std::runtime_error where the bag
  /// is damaged.
  bool sense(Senses& senses) override;
  void send(const MotorCommand&) override {}
  void stop() noexcept override {}

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace striate::ros
