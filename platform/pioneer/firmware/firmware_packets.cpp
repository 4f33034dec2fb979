#include <algorithm>
#include <cmath>

#include "striate/platform/pioneer/firmware/arcos_firmware.hpp"

/// What ArcosFirmware puts into the packets that it sends.
namespace striate::pioneer {

using arcos::Packet;
using arcos::SipFlag;

namespace {

constexpr double kTicksPerMm = 128.0;  // encoder ticks; TicksMM of a real P3-DX's CONFIGpac
/// Charge by voltage: LowBattery of a P3-DX's FLASH is empty, three fresh lead batteries at rest
/// are full (ours: a straight line between them)
constexpr double kEmpty_v = 11.0;
constexpr double kFull_v = 12.7;  // V, see kEmpty_v
/// Bit of the bumper segment that looks along the robot's middle, of bits 1 to 5; ARCOS manual
constexpr std::uint8_t kMiddleBumper = 0x08;
/// Finest step of the laser in the stream: an LMS-200's. A hundredth of a degree over a whole turn
/// would be more than a line carries (ours)
constexpr int kFinest_cdeg = 25;
constexpr double kStandsMm_s = 5.0;  // slower than this, the SIP says that it stands (ours)

std::int16_t as_i16(double value) {
  return static_cast<std::int16_t>(std::lround(std::clamp(value, -32767.0, 32767.0)));
}

std::uint16_t as_count(double value) {
  return static_cast<std::uint16_t>(std::llround(value) & 0x7fff);
}

}  // namespace

void ArcosFirmware::send_config() {
  arcos::ConfigPac config;
  config.type = "Pioneer";
  config.subtype = settings_.subclass;
  config.serial = settings_.serial;
  constexpr WheelControl::Limits kTop = WheelControl::kTop;
  config.rotation_top_deg_s = static_cast<std::uint16_t>(kTop.turn_deg_s);
  config.velocity_top_mm_s = static_cast<std::uint16_t>(kTop.forward_mm_s);
  config.rotation_acceleration_top_deg_s2 =
      static_cast<std::uint16_t>(kTop.turn_acceleration_deg_s2);
  config.acceleration_top_mm_s2 = static_cast<std::uint16_t>(kTop.acceleration_mm_s2);
  config.pwm_max = 500;
  config.name = settings_.name;
  config.sip_cycle_ms = static_cast<std::uint8_t>(settings_.sip_cycle_ms);
  config.front_sonar = config.rear_sonar = 1;
  config.low_battery_dv = 110;
  config.rev_count = 16570;
  config.watchdog_ms = static_cast<std::uint16_t>(settings_.watchdog_ms);
  config.stall_value = 200;
  config.rotation_max_deg_s = 100;
  config.velocity_max_mm_s = 750;
  config.rotation_acceleration_deg_s2 = config.rotation_deceleration_deg_s2 = 100;
  config.acceleration_mm_s2 = config.deceleration_mm_s2 = 300;
  config.front_bumpers = config.rear_bumpers = 1;
  config.sonar_cycle_ms = 40;
  config.has_gyro = 1;
  config.ticks_mm = static_cast<std::uint16_t>(kTicksPerMm);
  config.firmware = "S.1";
  send(arcos::write_config_pac(config));
}

void ArcosFirmware::send_encoders() {
  const auto ticks = [](double mm) {
    return static_cast<std::int32_t>(std::llround(mm * kTicksPerMm));
  };
  send(arcos::write_encoders({ticks(left_mm_), ticks(right_mm_)}));
}

void ArcosFirmware::send_io() {
  arcos::IoPac io;
  io.front_bumpers = senses_.bumper_front ? kMiddleBumper : 0;
  io.rear_bumpers = senses_.bumper_rear ? kMiddleBumper : 0;
  io.digital_out = digital_out_;
  send(arcos::write_io(io));
}

void ArcosFirmware::send_battery() {
  const double battery_v = fake_battery_v_.value_or(senses_.battery_v);
  const double share = (battery_v - kEmpty_v) / (kFull_v - kEmpty_v);
  send(arcos::write_battery(
      {static_cast<std::uint8_t>(std::lround(100.0 * std::clamp(share, 0.0, 1.0)))}));
}

/// As many readings as a cycle has times 25 ms. What rounding takes from one is given to the next,
/// so that their sum is the turn.
void ArcosFirmware::send_gyro() {
  const int count = std::max(1, settings_.sip_cycle_ms / arcos::GyroPac::kReading_ms);
  const double cycle_s = settings_.sip_cycle_ms / 1000.0;
  const double count_deg = arcos::GyroPac::kCount_deg_s * cycle_s / count;
  arcos::GyroPac gyro;
  for (int left = count; left > 0; --left) {
    const double counts =
        std::clamp(std::round(turned_deg_ / left / count_deg), -double{arcos::GyroPac::kStands},
                   double{arcos::GyroPac::kStands - 1});
    turned_deg_ -= counts * count_deg;
    gyro.readings.push_back(
        static_cast<std::int16_t>(arcos::GyroPac::kStands - static_cast<int>(counts)));
  }
  send(arcos::write_gyro(gyro));
}

void ArcosFirmware::laser(const std::vector<std::uint16_t>& ranges_mm) {
  if (!laser_wanted()) return;
  if (laser_mode_ == 1) {
    const arcos::Sip sip = odometry_sip();
    const arcos::OldSimLaser at{static_cast<std::int16_t>(sip.x), static_cast<std::int16_t>(sip.y),
                                sip.heading};
    for (const Packet& packet : arcos::write_old_sim_laser(at, ranges_mm)) send(packet);
    return;
  }
  for (const Packet& packet : arcos::write_sim_laser(ranges_mm)) send(packet);
}

std::vector<double> ArcosFirmware::laser_bearings_rad() const {
  const LaserField& field = laser_field_;
  const int step_cdeg = std::max(field.increment_cdeg, kFinest_cdeg);
  const int span_cdeg = 100 * (field.end_deg - field.start_deg);
  std::vector<double> bearings;
  for (int i = 0; i <= std::abs(span_cdeg) / step_cdeg; ++i) {
    const int turned_cdeg = span_cdeg < 0 ? -i * step_cdeg : i * step_cdeg;
    bearings.push_back(radians(field.start_deg + turned_cdeg / 100.0));
  }
  return bearings;
}

/// The place by odometry, in the units of the robot's model.
arcos::Sip ArcosFirmware::odometry_sip() const {
  const Pose2 pose = pose_mm();
  arcos::Sip sip;
  sip.x = as_count(pose.x_m / model_.distance_mm);
  sip.y = as_count(pose.y_m / model_.distance_mm);
  sip.heading = as_i16(pose.heading_rad / model_.angle_rad);
  return sip;
}

void ArcosFirmware::send_sip() {
  const double turn_mm_s = senses_.odometry.turn_rad_s * model_.half_axle_mm;
  const double forward_mm_s = 1000.0 * senses_.odometry.forward_m_s;
  arcos::Sip sip = odometry_sip();
  sip.left_mm_s = as_i16((forward_mm_s - turn_mm_s) / model_.velocity_mm_s);
  sip.right_mm_s = as_i16((forward_mm_s + turn_mm_s) / model_.velocity_mm_s);
  const bool moves = std::abs(forward_mm_s) + std::abs(turn_mm_s) > kStandsMm_s;
  sip.type = moves ? 0x33 : 0x32;
  const double battery_v = fake_battery_v_.value_or(senses_.battery_v);
  sip.battery_dv = static_cast<std::uint8_t>(std::clamp(std::lround(10.0 * battery_v), 0L, 255L));
  sip.stall_and_bumpers = static_cast<std::uint16_t>((senses_.stalled ? 0x0101 : 0) |
                                                     (senses_.bumper_rear ? 0x0008 : 0) |
                                                     (senses_.bumper_front ? 0x0800 : 0));
  sip.flags = static_cast<std::uint16_t>((motors_on_ ? SipFlag::motors_on : 0) |
                                         (sonar_on_ ? SipFlag::sonar_on : 0) |
                                         (senses_.stop_pressed ? SipFlag::stop_pressed : 0) |
                                         (senses_.joystick.button1 ? SipFlag::joystick_button : 0));
  sip.sonar.swap(fresh_sonar_);
  sip.digital_out = digital_out_;
  sip.battery_x10_dv = sip.battery_dv;
  sip.rotation_ddeg_s = as_i16(10.0 * degrees(senses_.odometry.turn_rad_s));
  send(arcos::write_sip(sip));
}

/// What goes with each SIP where it was asked for.
void ArcosFirmware::send_streams() {
  if (joystick_stream_ > 1) send(arcos::write_joystick(senses_.joystick));
  if (encoder_stream_ > 1) send_encoders();
  if (io_stream_ > 1) send_io();
  if (battery_stream_ > 1) send_battery();
  if (gyro_streams_) send_gyro();
}

}  // namespace striate::pioneer
