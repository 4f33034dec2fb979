#pragma once

#include <optional>
#include <string>
#include <vector>

#include "striate/platform/pioneer/arcos/packet.hpp"

/// The smaller packets of a robot: its names at the end of the handshake, the joystick, and what
/// only simulated robots send: the true pose and a laser inside the ARCOS stream.
namespace striate::pioneer::arcos {

/// Answer to SYNC2.
struct RobotNames {
  std::string name;      ///< "AMRISim", "MobileSim", the robot's own
  std::string kind;      ///< "Pioneer"
  std::string subclass;  ///< "p3dx", "p3dx-sh"
};
[[nodiscard]] std::optional<RobotNames> read_names(const Packet& packet);
[[nodiscard]] Packet write_names(const RobotNames& names);

/// JOYINFO's answer. Axes 0..1023, the middle is 512.
struct Joystick {
  static constexpr std::uint8_t kId = 0xf8;  ///< JOYSTICKpac's packet type; ARCOS manual
  bool button1 = false;
  bool button2 = false;
  std::uint16_t x = 512;
  std::uint16_t y = 512;
  std::uint16_t throttle = 512;
};
[[nodiscard]] std::optional<Joystick> read_joystick(const Packet& packet);
[[nodiscard]] Packet write_joystick(const Joystick& joystick);

/// ENCODER's answer: ticks of the wheels.
struct Encoders {
  static constexpr std::uint8_t kId = 0x90;  ///< ENCODERpac's packet type; ARCOS manual
  std::int32_t left_ticks = 0;
  std::int32_t right_ticks = 0;
};
[[nodiscard]] Packet write_encoders(const Encoders& encoders);

/// IOREQUEST's answer: digital and analog ports, which nobody here reads.
struct IoPac {
  static constexpr std::uint8_t kId = 0xf0;  ///< IOpac's packet type; ARCOS manual
};
/// An IOpac of a robot whose ports have nothing to tell.
[[nodiscard]] Packet write_io();

/// SIMSTAT: the truth, to score a driver by. Simulated robots only.
struct SimStat {
  static constexpr std::uint8_t kId = 0x62;  ///< SIMSTAT's packet type, as MobileSim sends it
  std::int32_t x_mm = 0;
  std::int32_t y_mm = 0;
  std::int32_t heading_deg = 0;
};
[[nodiscard]] std::optional<SimStat> read_sim_stat(const Packet& packet);
[[nodiscard]] Packet write_sim_stat(const SimStat& stat);

/// Part of a sweep of the in-band laser. Simulated robots only.
struct SimLaser {
  /// Packet type of a laser in the stream, as MobileSim sends it
  static constexpr std::uint8_t kId = 0x61;
  /// Readings a packet, as MobileSim sends them: 181 in six packets
  static constexpr std::size_t kMostReadings = 32;
  std::uint16_t total = 0;  ///< readings of the whole sweep, from right to left
  std::uint16_t first = 0;  ///< of these
  std::vector<std::uint16_t> ranges_mm;
};
[[nodiscard]] std::optional<SimLaser> read_sim_laser(const Packet& packet);
/// Puts the parts of sweeps together.
class SimLaserSweep {
 public:
  /// True when this part completes a sweep, which `ranges_mm` then holds.
  bool take(const SimLaser& part);
  [[nodiscard]] const std::vector<std::uint16_t>& ranges_mm() const { return ranges_mm_; }

 private:
  std::vector<std::uint16_t> ranges_mm_;
  std::size_t next_ = 0;  ///< the part that is due; a lost one loses its sweep
};
/// A sweep as the packets it takes.
[[nodiscard]] std::vector<Packet> write_sim_laser(const std::vector<std::uint16_t>& ranges_mm);

}  // namespace striate::pioneer::arcos
