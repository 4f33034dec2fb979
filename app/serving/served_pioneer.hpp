#pragma once

#include "platform/pioneer/firmware/arcos_firmware.hpp"
#include "platform/simulator/simulated_pioneer.hpp"

namespace striate {

/// The simulated Pioneer under a real Pioneer's controller: what the firmware makes of the client's
/// bytes moves the simulated wheels, and what the simulated base feels goes into its packets.
class ServedPioneer {
 public:
  ServedPioneer(const simulator::World& world, std::uint64_t seed,
                const simulator::SimulatorSettings& settings,
                const pioneer::FirmwareSettings& firmware);

  static constexpr Duration kStep = std::chrono::milliseconds(10);
  /// One step of physics and controller.
  void step();

  [[nodiscard]] pioneer::ArcosFirmware& firmware() { return firmware_; }
  [[nodiscard]] const pioneer::ArcosFirmware& firmware() const { return firmware_; }
  [[nodiscard]] TimePoint now() const { return body_.clock().now(); }
  [[nodiscard]] Pose2 true_pose() const { return body_.scene().robot; }
  [[nodiscard]] double true_forward_m_s() const { return body_.scene().forward_m_s; }
  [[nodiscard]] const simulator::Judge& judge() const { return body_.judge(); }

 private:
  void hand_over_sonar();
  void hand_over_laser();

  simulator::SimulatedPioneer body_;
  pioneer::ArcosFirmware firmware_;
  Senses senses_;
  TimePoint sonar_stamp_;
  TimePoint next_laser_;
  double laser_range_m_;
};

}  // namespace striate
