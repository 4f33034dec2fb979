#pragma once

#include "striate/platform/pioneer/firmware/arcos_firmware.hpp"
#include "striate/platform/pioneer/firmware/servo_bus.hpp"
#include "striate/platform/served/served_laser.hpp"
#include "striate/platform/simulator/camera_link.hpp"
#include "striate/platform/simulator/range_finders.hpp"
#include "striate/platform/simulator/simulated_pioneer.hpp"

namespace striate::served {

/// Which of a Pioneer's devices are served.
struct ServedDevices {
  pioneer::FirmwareSettings base{};
  pioneer::LaserKind laser = pioneer::LaserKind::hokuyo;  ///< on a line of its own
};

/// The simulated Pioneer under a real Pioneer's devices: what controller and servos make of the
/// client's bytes moves the simulated wheels and head, and what the simulated body feels goes into
/// the packets of base and laser.
class ServedPioneer {
 public:
  ServedPioneer(const simulator::World& world, std::uint64_t seed,
                const simulator::SimulatorSettings& settings, const ServedDevices& devices,
                const RobotDescription& robot = {});

  /// Of physics, as the simulated Pioneer's (10 ms)
  static constexpr Duration kStep = std::chrono::milliseconds(10);
  /// One step of physics and controller.
  void step();

  [[nodiscard]] pioneer::ArcosFirmware& firmware() { return firmware_; }
  [[nodiscard]] const pioneer::ArcosFirmware& firmware() const { return firmware_; }
  /// Pan (id 1) and tilt (id 2).
  [[nodiscard]] pioneer::ServoBus& servos() { return servos_; }
  [[nodiscard]] const pioneer::ServoBus& servos() const { return servos_; }
  [[nodiscard]] ServedLaser& laser() { return laser_; }
  [[nodiscard]] const ServedLaser& laser() const { return laser_; }
  /// A image is to be taken of this moment. Ask once after each step.
  [[nodiscard]] bool exposes() { return camera_.due(to_seconds(now())); }
  [[nodiscard]] simulator::SceneState scene() const { return body_.scene(); }
  [[nodiscard]] const simulator::FloorPlan& plan() const { return body_.plan(); }
  [[nodiscard]] TimePoint now() const { return body_.clock().now(); }
  [[nodiscard]] Pose2 true_pose() const { return body_.scene().robot; }
  [[nodiscard]] double true_forward_m_s() const { return body_.scene().forward_m_s; }
  [[nodiscard]] const simulator::Judge& judge() const { return body_.judge(); }

 private:
  void hand_over_sonar();
  void hand_over_laser();

  std::vector<Pose2> sonar_mounts_;
  simulator::SimulatedPioneer body_;
  pioneer::ArcosFirmware firmware_;
  pioneer::ServoBus servos_;
  ServedLaser laser_;
  simulator::CameraLink camera_;
  Senses senses_;
  TimePoint sonar_stamp_;
  TimePoint next_laser_;
  double laser_range_m_;
};

}  // namespace striate::served
