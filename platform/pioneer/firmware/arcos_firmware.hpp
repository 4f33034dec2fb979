#pragma once

#include <array>
#include <optional>

#include "striate/platform/interface/senses.hpp"
#include "striate/platform/pioneer/arcos/command.hpp"
#include "striate/platform/pioneer/arcos/config_pac.hpp"
#include "striate/platform/pioneer/arcos/other_packets.hpp"
#include "striate/platform/pioneer/arcos/packet_stream.hpp"
#include "striate/platform/pioneer/arcos/sip.hpp"
#include "striate/platform/pioneer/firmware/wheel_control.hpp"
#include "striate/platform/pioneer/robot_model.hpp"

namespace striate::pioneer {

struct FirmwareSettings {
  std::string name = "Striate";
  std::string subclass = "p3dx-sh";
  std::string serial = "SIM";  ///< with this some clients know that they may ask for a laser
  int watchdog_ms = 2000;      ///< WatchDog in a P3-DX's FLASH; ARCOS manual
  int sip_cycle_ms = 100;      ///< SipCycle of a real P3-DX; ARCOS manual
};

/// What the body under the firmware feels and does.
struct FirmwareSenses {
  Odometry odometry;  ///< since the start; the firmware has its own origin
  double battery_v = 12.7;
  bool stalled = false;
  bool bumper_front = false;
  bool bumper_rear = false;
  bool stop_pressed = false;  ///< the button on the robot
  arcos::Joystick joystick;
  Pose2 true_pose;
};

/// The robot's side of ARCOS, as a real Pioneer's controller keeps it: handshake, commands, motor
/// ramps, a SIP every cycle, and the watchdog that stops the wheels after two seconds without a
/// packet and takes the old motion up again with the next one. Pure: bytes, senses and times go in,
/// bytes and wheel speeds come out. The simulated robot and the driver's tests run on it.
class ArcosFirmware {
 public:
  explicit ArcosFirmware(const FirmwareSettings& settings);

  void receive(ByteView bytes, TimePoint now);
  /// One control step: ramps, watchdog, packets that are due.
  void step(TimePoint now, Duration step, const FirmwareSenses& senses);
  /// A sonar disc has fired. range_m: +inf is no echo.
  void sonar(std::size_t disc, double range_m);
  /// A laser sweep from right to left, sent where a client has asked for one.
  void laser(const std::vector<std::uint16_t>& ranges_mm);
  [[nodiscard]] bool laser_wanted() const { return connected_ && laser_wanted_; }
  [[nodiscard]] Bytes take_output();

  /// What the wheels are told to do now, after ramps.
  [[nodiscard]] double forward_m_s() const { return wheels_.forward_mm_s() / 1000.0; }
  [[nodiscard]] double turn_rad_s() const { return radians(wheels_.turn_deg_s()); }
  /// The wheels are told to stand or are slowing down to a stand.
  [[nodiscard]] bool commanded_to_stand() const { return wheels_.wants_to_stand(); }
  [[nodiscard]] bool connected() const { return connected_; }
  [[nodiscard]] bool motors_on() const { return motors_on_; }
  [[nodiscard]] bool watchdog_has_stopped() const { return watchdog_stopped_; }
  /// Ends the session, as switching the robot off and on does.
  void reboot();
  [[nodiscard]] const arcos::StreamCounters& counters() const { return stream_.counters(); }

 private:
  void handle(const arcos::Packet& packet);
  void handshake(const arcos::Packet& packet);
  bool handle_motion(const arcos::Packet& packet, const arcos::Argument& argument);
  void handle_setting(const arcos::Packet& packet, const arcos::Argument& argument);
  void handle_request(const arcos::Packet& packet, const arcos::Argument& argument);
  void open();
  void close();
  void set_motors(bool on);
  void send(const arcos::Packet& packet);
  void send_config();
  void send_encoders();
  void send_sip();
  void watch(TimePoint now);
  void drive_by_joystick();
  [[nodiscard]] Pose2 pose_mm() const;

  FirmwareSettings settings_;
  RobotModel model_;
  arcos::PacketStream stream_;
  Bytes output_;
  WheelControl wheels_;
  FirmwareSenses senses_;

  int sync_expected_ = 0;
  bool connected_ = false;
  bool motors_on_ = false;
  bool sonar_on_ = true;
  bool joystick_allowed_ = false;
  bool joystick_drives_ = false;
  bool stop_was_pressed_ = false;
  bool laser_wanted_ = false;
  bool watchdog_stopped_ = false;
  int joystick_stream_ = 0;
  int encoder_stream_ = 0;
  std::optional<double> fake_battery_v_;
  Pose2 origin_;  ///< the body's odometry where the firmware's is 0
  std::vector<arcos::SonarReading> fresh_sonar_;

  TimePoint now_;
  TimePoint last_packet_;
  TimePoint next_sip_;
  TimePoint incomplete_since_;
  bool incomplete_ = false;
};

}  // namespace striate::pioneer
