#include "striate/platform/pioneer/turret/turret_driver.hpp"

#include <algorithm>
#include <cmath>

namespace striate::pioneer {

using dynamixel::Error;
using dynamixel::Register;

namespace {

/// Position, speed, load, voltage and temperature stand side by side.
constexpr std::size_t kStateSize = 8;
/// As many registers stand from the position to the last one, 49; AX-12A control table
constexpr std::size_t kMostAsked = 14;
/// 2 deg, seven steps of the encoder: a servo under load stops short of its goal (ours)
constexpr double kThere_rad = 0.035;
/// Three steps of the encoder (0.293 deg): less is its jitter
constexpr double kProgress_rad = 0.015;
constexpr std::uint32_t kMix = 69069;  ///< Marsaglia's multiplier modulo 2^32
/// A position that is older where it is heard is none: half of what may be old at the wheels (ours)
constexpr Duration kOldReply = std::chrono::milliseconds(250);
constexpr std::uint16_t kFullTorque = 1023;  ///< AX-12A control table, torque limit: ten bits
/// AX-12A control table, present load: bit 10 is the direction
constexpr std::uint16_t kClockwiseLoad = 1U << 10;

}  // namespace

TurretDriver::TurretDriver(const TurretSettings& settings) : settings_(settings) {
  servos_[0].id = static_cast<std::uint8_t>(settings.pan_id);
  servos_[0].most_rad = settings.most_pan_rad;
  servos_[1].id = static_cast<std::uint8_t>(settings.tilt_id);
  servos_[1].most_rad = settings.most_tilt_rad;
}

void TurretDriver::command(const HeadPose& wanted) {
  const std::array<double, 2> angles{wanted.pan_rad, wanted.tilt_rad};
  for (std::size_t i = 0; i < servos_.size(); ++i) {
    Servo& servo = servos_[i];
    if (!std::isfinite(angles[i])) continue;
    servo.goal_rad = std::clamp(angles[i], -servo.most_rad, servo.most_rad);
  }
}

void TurretDriver::reset() {
  for (Servo& servo : servos_) {
    servo.goal_rad.reset();
    servo.health.stuck = false;
    if (!servo.health.tripped) continue;
    servo.health.tripped = false;
    append(output_, dynamixel::write_word(servo.id, Register::torque_limit, kFullTorque));
  }
}

Bytes TurretDriver::take_output() {
  Bytes bytes;
  bytes.swap(output_);
  return bytes;
}

void TurretDriver::receive(ByteView bytes, TimePoint now) {
  stream_.push(bytes);
  while (const auto packet = stream_.next()) {
    // Replies to writes have no parameters and need none.
    const auto asked_at = questions_.answer({packet->id, packet->parameters.size()});
    // A reply to a question that was given up is late: the head may look elsewhere by now.
    const bool meant = asked_at && waiting_ && *asked_at == asked_at_;
    if (!meant || packet->id != servos_[turn_].id || now - asked_at_ > kOldReply) continue;
    take(servos_[turn_], *packet, now);
    waiting_ = false;
    turn_ = (turn_ + 1) % servos_.size();
  }
}

void TurretDriver::take(Servo& servo, const dynamixel::Packet& packet, TimePoint now) {
  ByteReader reader(packet.parameters, ByteReader::Beyond::zero);
  ServoHealth& health = servo.health;
  health.angle_rad = dynamixel::angle_of(reader.u16());
  (void)reader.u16();
  const std::uint16_t load = reader.u16();
  health.load = (load & 0x3ffU) / 1023.0 * ((load & kClockwiseLoad) != 0 ? -1.0 : 1.0);
  health.voltage_v = reader.u8() / 10.0;
  health.temperature_c = reader.u8();
  health.errors = packet.code;
  // What it did before, or while it was silent, says nothing about whether it is stuck.
  if (!health.known || health.silent) begin_to_watch(servo, now);
  if ((packet.code & (Error::overload | Error::overheat)) != 0) health.tripped = true;
  health.known = true;
  health.stamp = now;
  health.missed_in_a_row = 0;
  health.silent = false;
  watch_progress(servo, now);
}

void TurretDriver::begin_to_watch(Servo& servo, TimePoint now) {
  servo.from_rad = servo.health.angle_rad;
  servo.moved_at = now;
}

/// By what the servo does, not by how far it has still to go: a goal that moves on must not excuse
/// a servo that does not.
void TurretDriver::watch_progress(Servo& servo, TimePoint now) {
  const double left = servo.goal_rad ? *servo.goal_rad - servo.health.angle_rad : 0.0;
  const double towards = (servo.health.angle_rad - servo.from_rad) * (left < 0.0 ? -1.0 : 1.0);
  if (std::abs(left) < kThere_rad || towards >= kProgress_rad) {
    begin_to_watch(servo, now);
    servo.health.stuck = false;
  } else if (now - servo.moved_at > from_seconds(settings_.stuck_after_s)) {
    servo.health.stuck = true;
  } else if (towards < 0.0) {
    servo.from_rad = servo.health.angle_rad;
  }
}

void TurretDriver::miss(Servo& servo) {
  ++servo.health.missed;
  if (++servo.health.missed_in_a_row >= settings_.silent_after) servo.health.silent = true;
}

void TurretDriver::write_goals() {
  std::vector<dynamixel::Goal> goals;
  for (const Servo& servo : servos_) {
    // Positions first: a servo that jumps to an unread place would tear at its cables.
    if (!servo.goal_rad || !servo.health.known || servo.health.tripped) continue;
    goals.push_back({servo.id, *servo.goal_rad, settings_.most_speed_rad_s});
  }
  if (!goals.empty()) append(output_, dynamixel::move(goals));
}

void TurretDriver::ask(TimePoint now) {
  // In no order: where many replies were lost, the next ones would match them one by one.
  mixed_ = mixed_ * kMix + 1;
  size_ = kStateSize + (mixed_ >> 16U) % (kMostAsked - kStateSize + 1);
  const std::uint8_t id = servos_[turn_].id;
  append(output_, dynamixel::read(id, Register::position, static_cast<std::uint8_t>(size_)));
  questions_.ask({id, size_}, now);
  waiting_ = true;
  asked_at_ = now;
}

void TurretDriver::tick(TimePoint now) {
  if (waiting_) {
    if (now - asked_at_ < from_seconds(settings_.patience_s)) return;
    // Bytes of half a reply must not swallow the next one.
    while (stream_.waiting()) {
      stream_.give_up_waiting();
      while (stream_.next()) {
      }
    }
    miss(servos_[turn_]);
    waiting_ = false;
    turn_ = (turn_ + 1) % servos_.size();
  }
  if (turn_ == 0) write_goals();
  ask(now);
}

}  // namespace striate::pioneer
