#pragma once

#include <array>
#include <optional>
#include <utility>

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
  double true_turn_rad_s = 0.0;  ///< as a gyro feels it
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
  /// A laser sweep, sent where a client has asked for one. @param ranges_mm one for each of
  /// laser_bearings_rad()
  void laser(const std::vector<std::uint16_t>& ranges_mm);
  [[nodiscard]] bool laser_wanted() const { return connected_ && laser_mode_ != 0; }
  /// Where the readings look that the client wants, in their order; at first from right to left.
  [[nodiscard]] std::vector<double> laser_bearings_rad() const;
  /// Where a client of a simulated robot has put it, in truth, since the last call.
  [[nodiscard]] std::optional<Pose2> take_new_place() { return std::exchange(new_place_, {}); }
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
  /// What of the in-band laser's turn is told, as MobileSim's begins.
  struct LaserField {
    int start_deg = -90;
    int end_deg = 90;
    int increment_cdeg = 100;
  };
  void handle(const arcos::Packet& packet);
  void handshake(const arcos::Packet& packet);
  bool handle_motion(const arcos::Packet& packet, const arcos::Argument& argument);
  void handle_setting(const arcos::Packet& packet, const arcos::Argument& argument);
  void handle_request(const arcos::Packet& packet, const arcos::Argument& argument);
  void handle_stream(const arcos::Packet& packet, const arcos::Argument& argument);
  bool handle_laser(const arcos::Packet& packet, const arcos::Argument& argument);
  void handle_simulator(const arcos::Packet& packet);
  void open();
  void close();
  void set_motors(bool on);
  void send(const arcos::Packet& packet);
  void send_config();
  void send_encoders();
  void send_io();
  void send_battery();
  void send_gyro();
  void send_sip();
  void send_streams();
  void count_wheels(const Odometry& odometry);
  void watch(TimePoint now);
  void drive_by_joystick();
  [[nodiscard]] Pose2 pose_mm() const;
  [[nodiscard]] arcos::Sip odometry_sip() const;

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
  bool watchdog_stopped_ = false;
  int joystick_stream_ = 0;
  int encoder_stream_ = 0;
  int io_stream_ = 0;
  int battery_stream_ = 0;
  bool gyro_streams_ = false;
  double turned_deg_ = 0.0;  ///< by the gyro, since its last reading; less what that has told
  double left_mm_ = 0.0;     ///< that the wheels have gone since the session was opened
  double right_mm_ = 0.0;
  bool wheels_counted_ = false;  ///< there is an odometry to count from
  std::uint8_t digital_out_ = 0;
  int laser_mode_ = 0;
  LaserField laser_field_;
  std::optional<double> fake_battery_v_;
  Pose2 origin_;                ///< the body's odometry where the firmware's is 0
  std::optional<Pose2> start_;  ///< in truth
  std::optional<Pose2> new_place_;
  std::vector<arcos::SonarReading> fresh_sonar_;

  TimePoint now_;
  TimePoint last_packet_;
  TimePoint next_sip_;
  TimePoint incomplete_since_;
  bool incomplete_ = false;
};

}  // namespace striate::pioneer
