#include "striate/platform/pioneer/firmware/arcos_firmware.hpp"

#include <algorithm>
#include <cmath>

namespace striate::pioneer {

using arcos::Command;
using arcos::Packet;

namespace {

constexpr std::uint16_t kToldWithoutEchoMm =
    5000;  // what a real P3-DX tells where no echo returned
/// Two turns of 16 discs: what waits longer has been fired again
constexpr std::size_t kMostFreshReadings = 32;

const RobotModel& model_of(const std::string& subclass) {
  const RobotModel* model = find_model(subclass);
  return model != nullptr ? *model : *find_model("p3dx-sh");
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
  fake_battery_v_.reset();
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

/// Metres are millimetres here.
Pose2 ArcosFirmware::pose_mm() const {
  const Pose2 pose = inverse_transform(origin_, senses_.odometry.pose);
  return {1000.0 * pose.x_m, 1000.0 * pose.y_m, pose.heading_rad};
}

void ArcosFirmware::sonar(std::size_t disc, double range_m) {
  if (!connected_ || !sonar_on_ || fresh_sonar_.size() >= kMostFreshReadings) return;
  const double mm =
      std::isfinite(range_m) ? std::clamp(1000.0 * range_m, 0.0, 5000.0) : kToldWithoutEchoMm;
  fresh_sonar_.push_back(
      {static_cast<std::uint8_t>(disc), static_cast<std::uint16_t>(std::lround(mm))});
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
