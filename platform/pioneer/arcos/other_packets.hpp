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

/// IOREQUEST's answer: counted groups of digital inputs, digital outputs and analog inputs.
struct IoPac {
  static constexpr std::uint8_t kId = 0xf0;  ///< IOpac's packet type; ARCOS manual
  std::uint8_t digital_in = 0;
  std::uint8_t front_bumpers = 0;
  std::uint8_t rear_bumpers = 0;
  std::uint8_t digital_out = 0;
};
/// Of a robot with nothing at its infrared and analog ports.
[[nodiscard]] Packet write_io(const IoPac& io = {});

/// BATTERYINFO's answer.
struct BatteryPac {
  static constexpr std::uint8_t kId = 0xfa;  ///< as ARIA reads it
  std::uint8_t charge_percent = 0;
};
/// Of a robot with one battery, without flags.
[[nodiscard]] Packet write_battery(const BatteryPac& battery);

/// GYRO's answer: what the gyro told each 25 ms since the last packet.
struct GyroPac {
  static constexpr std::uint8_t kId = 0x98;  ///< as ARIA reads it
  static constexpr int kReading_ms = 25;     ///< of one reading; ARIA's gyro
  static constexpr int kStands = 512;        ///< counts that mean no turning: middle of ten bits
  /// Of one count, clockwise positive: 5 V in 1023 counts, 300 deg/s in 2.5 V, and the scale of a
  /// P3-DX's gyro; ARIA, p3dx-sh.p
  static constexpr double kCount_deg_s = 5.0 / 1023.0 * 300.0 / 2.5 * 1.626;
  static constexpr std::uint8_t kTemperature = 128;  ///< counts, of which ARIA makes nothing
  std::vector<std::int16_t> readings;                ///< counts
};
[[nodiscard]] Packet write_gyro(const GyroPac& gyro);

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
/// The older form, 0x60: ranges alone, behind the pose by odometry in the SIP's own units.
struct OldSimLaser {
  static constexpr std::uint8_t kId = 0x60;  ///< as ARIA reads it
  std::int16_t x = 0;
  std::int16_t y = 0;
  std::int16_t heading = 0;
};
[[nodiscard]] std::vector<Packet> write_old_sim_laser(const OldSimLaser& at,
                                                      const std::vector<std::uint16_t>& ranges_mm);

}  // namespace striate::pioneer::arcos
