#include "striate/platform/pioneer/firmware/arcos_firmware.hpp"

#include <algorithm>
#include <cmath>

namespace striate::pioneer {

using arcos::Command;
using arcos::Packet;
using arcos::SipFlag;

namespace {

constexpr std::uint16_t kNoEchoMm = 5000;  // what a real P3-DX tells where no echo returned
constexpr double kTicksPerMm = 128.0;      // encoder ticks; TicksMM of a real P3-DX's CONFIGpac
constexpr double kStandsMm_s = 5.0;        // slower than this, the SIP says that it stands (ours)
/// Two turns of 16 discs: what waits longer has been fired again
constexpr std::size_t kMostFreshReadings = 32;

const RobotModel& model_of(const std::string& subclass) {
  const RobotModel* model = find_model(subclass);
  return model != nullptr ? *model : *find_model("p3dx-sh");
}

std::int16_t as_i16(double value) {
  return static_cast<std::int16_t>(std::lround(std::clamp(value, -32767.0, 32767.0)));
}

std::uint16_t as_count(double value) {
  return static_cast<std::uint16_t>(std::llround(value) & 0x7fff);
}

}  // namespace

ArcosFirmware::ArcosFirmware(const FirmwareSettings& settings)
    : settings_(settings), model_(model_of(settings.subclass)) {}

void ArcosFirmware::send(const Packet& packet) {
  append(output_, arcos::encode(packet));
}

Bytes ArcosFirmware::take_output() {
  Bytes bytes;
  bytes.swap(output_);
  return bytes;
}

void ArcosFirmware::receive(ByteView bytes, TimePoint now) {
  now_ = std::max(now_, now);
  if (!incomplete_) incomplete_since_ = now_;
  stream_.push(bytes);
  while (const auto packet = stream_.next()) {
    last_packet_ = now_;
    incomplete_since_ = now_;
    if (connected_) {
      handle(*packet);
    } else {
      handshake(*packet);
    }
  }
  incomplete_ = stream_.waiting();
}

void ArcosFirmware::handshake(const Packet& packet) {
  // After the names either OPEN, with or without its argument, or a new handshake.
  if (sync_expected_ == 3 && packet.id == static_cast<std::uint8_t>(Command::open)) {
    open();
    return;
  }
  const bool is_sync = packet.id <= 2 && packet.payload.empty();
  const bool in_order =
      is_sync && (packet.id == 0 || packet.id == sync_expected_ || packet.id + 1 == sync_expected_);
  if (!in_order) {
    sync_expected_ = 0;
    return;
  }
  sync_expected_ = packet.id + 1;
  if (packet.id < 2) {
    send(packet);
  } else {
    send(arcos::write_names({settings_.name, "Pioneer", settings_.subclass}));
  }
}

void ArcosFirmware::open() {
  connected_ = true;
  wheels_.release();
  wheels_.limits() = {};
  motors_on_ = false;
  sonar_on_ = true;
  joystick_allowed_ = laser_wanted_ = watchdog_stopped_ = false;
  joystick_stream_ = encoder_stream_ = 0;
  fresh_sonar_.clear();
  origin_ = senses_.odometry.pose;
  next_sip_ = now_;
}

void ArcosFirmware::close() {
  connected_ = false;
  sync_expected_ = 0;
  set_motors(false);
}

void ArcosFirmware::reboot() {
  close();
  output_.clear();
  stream_.clear();
}

void ArcosFirmware::set_motors(bool on) {
  if (on != motors_on_) wheels_.release();
  motors_on_ = on && !senses_.stop_pressed;
}

void ArcosFirmware::handle(const Packet& packet) {
  const arcos::Argument argument = arcos::read_argument(packet);
  if (handle_motion(packet, argument)) return;
  handle_setting(packet, argument);
  handle_request(packet, argument);
}

void ArcosFirmware::send_config() {
  arcos::ConfigPac config;
  config.type = "Pioneer";
  config.subtype = settings_.subclass;
  config.serial = settings_.serial;
  config.rotation_top_deg_s = 360;
  config.velocity_top_mm_s = 1000;
  config.rotation_acceleration_top_deg_s2 = 300;
  config.acceleration_top_mm_s2 = 2000;
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
  config.ticks_mm = static_cast<std::uint16_t>(kTicksPerMm);
  config.firmware = "S.1";
  send(arcos::write_config_pac(config));
}

void ArcosFirmware::send_encoders() {
  // Ticks count what the odometry's way and turn make of the wheels.
  const Pose2 pose = pose_mm();
  const double turn_mm = pose.heading_rad * model_.half_axle_mm;
  send(arcos::write_encoders(
      {static_cast<std::int32_t>(std::lround((pose.x_m - turn_mm) * kTicksPerMm)),
       static_cast<std::int32_t>(std::lround((pose.x_m + turn_mm) * kTicksPerMm))}));
}

/// Metres are millimetres here.
Pose2 ArcosFirmware::pose_mm() const {
  const Pose2 pose = inverse_transform(origin_, senses_.odometry.pose);
  return {1000.0 * pose.x_m, 1000.0 * pose.y_m, pose.heading_rad};
}

void ArcosFirmware::sonar(std::size_t disc, double range_m) {
  if (!connected_ || !sonar_on_ || fresh_sonar_.size() >= kMostFreshReadings) return;
  const double mm = std::isfinite(range_m) ? std::clamp(1000.0 * range_m, 0.0, 5000.0) : kNoEchoMm;
  fresh_sonar_.push_back(
      {static_cast<std::uint8_t>(disc), static_cast<std::uint16_t>(std::lround(mm))});
}

void ArcosFirmware::laser(const std::vector<std::uint16_t>& ranges_mm) {
  if (!laser_wanted()) return;
  for (const Packet& packet : arcos::write_sim_laser(ranges_mm)) send(packet);
}

void ArcosFirmware::send_sip() {
  const Pose2 pose = pose_mm();
  const double turn_mm_s = senses_.odometry.turn_rad_s * model_.half_axle_mm;
  const double forward_mm_s = 1000.0 * senses_.odometry.forward_m_s;
  arcos::Sip sip;
  sip.x = as_count(pose.x_m / model_.distance_mm);
  sip.y = as_count(pose.y_m / model_.distance_mm);
  sip.heading = as_i16(pose.heading_rad / model_.angle_rad);
  sip.left_mm_s = as_i16(forward_mm_s - turn_mm_s);
  sip.right_mm_s = as_i16(forward_mm_s + turn_mm_s);
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
  sip.battery_x10_dv = sip.battery_dv;
  sip.rotation_ddeg_s = as_i16(10.0 * degrees(senses_.odometry.turn_rad_s));
  send(arcos::write_sip(sip));
  if (joystick_stream_ > 1) send(arcos::write_joystick(senses_.joystick));
  if (encoder_stream_ > 1) send_encoders();
}

void ArcosFirmware::watch(TimePoint now) {
  const bool silent =
      connected_ && now - last_packet_ > std::chrono::milliseconds(settings_.watchdog_ms);
  wheels_.hold(silent);
  watchdog_stopped_ = silent;
  if (senses_.stop_pressed && !stop_was_pressed_) {
    wheels_.emergency_stop();
    motors_on_ = false;  // ENABLE is needed again
  }
  stop_was_pressed_ = senses_.stop_pressed;
}

void ArcosFirmware::drive_by_joystick() {
  constexpr double kMostMm_s = 400.0;  // of a full joystick: a man's walk beside the robot (ours)
  constexpr double kMostDeg_s = 50.0;  // of a full joystick: half of RotVelMax
  const arcos::Joystick& joystick = senses_.joystick;
  if (joystick_allowed_ && joystick.button1 && motors_on_) {
    wheels_.set_forward(kMostMm_s * (joystick.y - 512) / 512.0);
    wheels_.set_turn(-kMostDeg_s * (joystick.x - 512) / 512.0);
    joystick_drives_ = true;
  } else if (joystick_drives_) {
    wheels_.stop();
    joystick_drives_ = false;
  }
}

void ArcosFirmware::step(TimePoint now, Duration step, const FirmwareSenses& senses) {
  now_ = now;
  senses_ = senses;
  if (incomplete_ && now - incomplete_since_ > arcos::kLongestPacket) {
    stream_.give_up_waiting();
    incomplete_since_ = now;
    receive({}, now);
  }
  drive_by_joystick();
  watch(now);
  wheels_.step(to_seconds(step), degrees(pose_mm().heading_rad));
  if (!connected_ || now < next_sip_) return;
  send_sip();
  next_sip_ += std::chrono::milliseconds(settings_.sip_cycle_ms);
  if (next_sip_ <= now) next_sip_ = now + std::chrono::milliseconds(settings_.sip_cycle_ms);
}

}  // namespace striate::pioneer
