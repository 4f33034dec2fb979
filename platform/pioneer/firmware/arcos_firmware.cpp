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
  joystick_allowed_ = watchdog_stopped_ = gyro_streams_ = false;
  joystick_stream_ = encoder_stream_ = io_stream_ = battery_stream_ = laser_mode_ = 0;
  laser_field_ = {};
  left_mm_ = right_mm_ = 0.0;
  digital_out_ = 0;
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
  if (handle_laser(packet, argument)) return;
  handle_setting(packet, argument);
  handle_request(packet, argument);
  handle_stream(packet, argument);
  handle_simulator(packet);
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

/// What each wheel has rolled since the last step: the way along the middle heading, and the turn.
void ArcosFirmware::count_wheels(const Odometry& odometry) {
  const Pose2 before = std::exchange(senses_.odometry, odometry).pose;
  if (!std::exchange(wheels_counted_, true)) return;
  const Pose2& now = odometry.pose;
  const double turn_rad = wrap_angle(now.heading_rad - before.heading_rad);
  const double along_rad = before.heading_rad + turn_rad / 2.0;
  const double way_mm = 1000.0 * ((now.x_m - before.x_m) * std::cos(along_rad) +
                                  (now.y_m - before.y_m) * std::sin(along_rad));
  left_mm_ += way_mm - turn_rad * model_.half_axle_mm;
  right_mm_ += way_mm + turn_rad * model_.half_axle_mm;
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
  if (!start_) start_ = senses.true_pose;
  count_wheels(senses.odometry);
  senses_ = senses;
  if (gyro_streams_) turned_deg_ += degrees(senses.true_turn_rad_s) * to_seconds(step);
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
  send_streams();
  next_sip_ += std::chrono::milliseconds(settings_.sip_cycle_ms);
  if (next_sip_ <= now) next_sip_ = now + std::chrono::milliseconds(settings_.sip_cycle_ms);
}

}  // namespace striate::pioneer
