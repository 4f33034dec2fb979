#include "striate/platform/pioneer/firmware/servo_model.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "striate/base/pioneer_devices.hpp"

namespace striate::pioneer {

using dynamixel::Error;
using dynamixel::Instruction;
using dynamixel::Register;

namespace {

/// AX-12A data sheet: 59 rpm without load
constexpr double kFastestRad_s = 59.0 * 2.0 * std::numbers::pi / 60.0;
/// Blocked for so long it gives up, as an AX-12A does after some seconds (ours)
constexpr double kOverloadAfter_s = 2.0;
constexpr double kServoThere_rad = 0.003;  // half a step of the position, 0.293 deg
/// AX-12A control table, speed and load: bit 10 is clockwise
constexpr std::uint16_t kClockwise = 1U << 10;
constexpr std::uint16_t kSizeBits = kClockwise - 1U;  // AX-12A control table: ten bits of size
/// 98 % of the most: what a servo tells that pushes against something (ours)
constexpr std::uint16_t kBlockedLoad = 1000;
/// Locked, only addresses 18 to 23 (hex) may be written; AX-12 manual, example 20
constexpr std::uint8_t kLastUnlocked = 0x23;
/// Half of the 300 degrees that it can tell; in wheel mode a turret's cables end there, too (ours)
constexpr double kEnd_rad = 150.0 * std::numbers::pi / 180.0;

/// A register that may be written, and within what; AX-12 manual, data range for writing.
struct Writable {
  std::uint8_t address;
  std::uint8_t size;
  std::uint16_t least;
  std::uint16_t most;
};
constexpr Writable kWritable[] = {
    {Register::id, 1, 0, 253},
    {Register::baud, 1, 0, 254},
    {Register::return_delay, 1, 0, 254},
    {Register::cw_limit, 2, 0, 1023},
    {Register::ccw_limit, 2, 0, 1023},
    {Register::most_temperature, 1, 0, 150},
    {Register::least_voltage, 1, 50, 250},
    {Register::most_voltage, 1, 50, 250},
    {Register::most_torque, 2, 0, 1023},
    {Register::status_level, 1, 0, 2},
    {Register::alarm_led, 1, 0, 127},
    {Register::alarm_shutdown, 1, 0, 127},
    {Register::torque_enable, 1, 0, 1},
    {Register::led, 1, 0, 1},
    {Register::cw_margin, 1, 0, 254},
    {Register::ccw_margin, 1, 0, 254},
    {Register::cw_slope, 1, 1, 254},
    {Register::ccw_slope, 1, 1, 254},
    {Register::goal_position, 2, 0, 1023},
    {Register::moving_speed, 2, 0, 1023},
    {Register::torque_limit, 2, 0, 1023},
    {Register::registered, 1, 0, 1},
    {Register::lock, 1, 0, 1},
    {Register::punch, 2, 0, 1023},
};

const Writable* writable_at(std::size_t address) {
  for (const Writable& place : kWritable) {
    if (place.address == address) return &place;
  }
  return nullptr;
}

}  // namespace

ServoModel::ServoModel(std::uint8_t id, double angle_rad) : angle_rad_(angle_rad) {
  set_to_factory(id);
}

/// The initial values of an AX-12A's control table, e-Manual; firmware as the servos of a PhantomX
/// turret tell it.
void ServoModel::set_to_factory(std::uint8_t id) {
  registers_.fill(0);
  registered_.clear();
  registers_[Register::model] = 12;
  registers_[Register::firmware] = 24;
  registers_[Register::id] = id;
  registers_[Register::baud] = 1;  // 1 Mbps
  registers_[Register::return_delay] = 250;
  set_word(Register::ccw_limit, 1023);
  registers_[Register::most_temperature] = 70;
  registers_[Register::least_voltage] = 60;
  registers_[Register::most_voltage] = 140;
  set_word(Register::most_torque, 1023);
  registers_[Register::status_level] = 2;
  registers_[Register::alarm_led] = registers_[Register::alarm_shutdown] =
      Error::overheat | Error::overload;
  registers_[Register::cw_margin] = registers_[Register::ccw_margin] = 1;
  registers_[Register::cw_slope] = registers_[Register::ccw_slope] = 32;
  set_word(Register::goal_position, dynamixel::ticks_of(angle_rad_));
  set_word(Register::torque_limit, word(Register::most_torque));
  registers_[Register::voltage] = 120;
  registers_[Register::temperature] = 35;
  set_word(Register::punch, 32);
  tell();
}

std::uint16_t ServoModel::word(std::uint8_t address) const {
  return static_cast<std::uint16_t>(registers_[address] | registers_[address + 1U] << 8U);
}

void ServoModel::set_word(std::uint8_t address, std::uint16_t value) {
  registers_[address] = static_cast<std::uint8_t>(value & 0xffU);
  registers_[address + 1U] = static_cast<std::uint8_t>(value >> 8U);
}

std::uint8_t ServoModel::check(std::uint8_t address, ByteView values) const {
  std::size_t at = 0;
  while (at < values.size()) {
    const Writable* place = writable_at(address + at);
    // Half a word, what is read only and what is beyond the table are all refused alike.
    if (place == nullptr || at + place->size > values.size()) return Error::range;
    const bool locked =
        registers_[Register::lock] != 0 &&
        (place->address < Register::torque_enable || place->address > kLastUnlocked);
    const unsigned value = values[at] | (place->size == 2 ? values[at + 1] << 8U : 0U);
    // Without angle limits the speed has a direction.
    const bool turns = place->address == Register::moving_speed && has_no_limits();
    const unsigned most = turns ? kClockwise | kSizeBits : place->most;
    if (locked || value < place->least || value > most) return Error::range;
    const bool outside = value < word(Register::cw_limit) || value > word(Register::ccw_limit);
    if (place->address == Register::goal_position && outside && !has_no_limits()) {
      return Error::angle_limit;
    }
    at += place->size;
  }
  return 0;
}

std::uint8_t ServoModel::write(std::uint8_t address, ByteView values) {
  if (const std::uint8_t error = check(address, values); error != 0) return error;
  std::copy(values.begin(), values.end(), registers_.begin() + address);
  const auto wrote = [&](std::uint8_t place) {
    return address <= place && place < address + values.size();
  };
  if (wrote(Register::goal_position)) registers_[Register::torque_enable] = 1;
  if (wrote(Register::torque_limit) && word(Register::torque_limit) > 0) {
    overloaded_ = false;
    pushing_s_ = 0.0;
    set_word(Register::goal_position, dynamixel::ticks_of(angle_rad_));
    watch_limits(false, 0.0);
  }
  return 0;
}

std::uint8_t ServoModel::read_into(dynamixel::Packet& reply, ByteView parameters) const {
  if (parameters.size() != 2) return Error::instruction;
  const std::size_t address = parameters[0];
  const std::size_t count = parameters[1];
  if (count == 0 || address + count > registers_.size()) return Error::range;
  const auto first = registers_.begin() + static_cast<std::ptrdiff_t>(address);
  reply.parameters.assign(first, first + static_cast<std::ptrdiff_t>(count));
  return 0;
}

std::uint8_t ServoModel::register_write(ByteView parameters) {
  if (parameters.size() < 2) return Error::instruction;
  if (const std::uint8_t error = check(parameters[0], parameters.subspan(1)); error != 0) {
    return error;
  }
  registered_.assign(parameters.begin(), parameters.end());
  registers_[Register::registered] = 1;
  return 0;
}

std::uint8_t ServoModel::act() {
  if (registered_.empty()) return Error::instruction;
  const Bytes registered = std::exchange(registered_, {});
  registers_[Register::registered] = 0;
  return write(registered[0], ByteView(registered).subspan(1));
}

std::optional<dynamixel::Packet> ServoModel::obey(const dynamixel::Packet& packet) {
  const ByteView parameters = packet.parameters;
  dynamixel::Packet reply{id(), 0, {}};
  std::uint8_t error = 0;
  int silent_below = 2;  // status return level
  switch (static_cast<Instruction>(packet.code)) {
    case Instruction::ping:
      silent_below = 0;
      break;
    case Instruction::read:
      silent_below = 1;
      error = read_into(reply, parameters);
      break;
    case Instruction::write:
      error = parameters.size() < 2 ? static_cast<std::uint8_t>(Error::instruction)
                                    : write(parameters[0], parameters.subspan(1));
      break;
    case Instruction::register_write:
      error = register_write(parameters);
      break;
    case Instruction::action:
      error = act();
      break;
    case Instruction::reset:
      set_to_factory(1);  // the id of a servo from the factory
      break;
    case Instruction::sync_write:  // for all or for none
    default:
      error = Error::instruction;
  }
  if (registers_[Register::status_level] < silent_below) return std::nullopt;
  reply.code = static_cast<std::uint8_t>(errors_ | error);
  return reply;
}

std::optional<dynamixel::Packet> ServoModel::refuse_sum() const {
  if (registers_[Register::status_level] < 2) return std::nullopt;
  return dynamixel::Packet{id(), static_cast<std::uint8_t>(errors_ | Error::checksum), {}};
}

bool ServoModel::has_no_limits() const {
  return word(Register::cw_limit) == 0 && word(Register::ccw_limit) == 0;
}

/// How far it would go within `dt_s`, were nothing in the way.
double ServoModel::wanted_rad(double dt_s) const {
  if (registers_[Register::torque_enable] == 0 || word(Register::torque_limit) == 0) return 0.0;
  const std::uint16_t told = word(Register::moving_speed);
  const double speed_rad_s = std::min((told & kSizeBits) * kServoSpeedStep_rad_s, kFastestRad_s);
  if (has_no_limits()) {  // a wheel: 0 stands
    const double way = speed_rad_s * dt_s * ((told & kClockwise) != 0 ? -1.0 : 1.0);
    return std::clamp(angle_rad_ + way, -kEnd_rad, kEnd_rad) - angle_rad_;
  }
  const double left_rad = dynamixel::angle_of(word(Register::goal_position)) - angle_rad_;
  if (std::abs(left_rad) <= kServoThere_rad) return 0.0;
  const double most = (told == 0 ? kFastestRad_s : speed_rad_s) * dt_s;
  return std::clamp(left_rad, -most, most);
}

void ServoModel::watch_limits(bool pushes, double dt_s) {
  pushing_s_ = pushes ? pushing_s_ + dt_s : 0.0;
  // What has switched it off stays until the torque limit is written.
  const bool off = (registers_[Register::alarm_shutdown] & Error::overload) != 0;
  overloaded_ = (overloaded_ && off) || pushing_s_ > kOverloadAfter_s;
  const std::uint8_t voltage = registers_[Register::voltage];
  errors_ = 0;
  if (voltage < registers_[Register::least_voltage] ||
      voltage > registers_[Register::most_voltage]) {
    errors_ |= Error::voltage;
  }
  if (registers_[Register::temperature] > registers_[Register::most_temperature]) {
    errors_ |= Error::overheat;
  }
  if (overloaded_) errors_ |= Error::overload;
  if ((errors_ & registers_[Register::alarm_shutdown]) != 0) set_word(Register::torque_limit, 0);
}

/// Position, speed and motion into the registers.
void ServoModel::tell() {
  const auto speed = static_cast<std::uint16_t>(std::lround(
      std::min(std::abs(speed_rad_s_) / kServoSpeedStep_rad_s, static_cast<double>(kSizeBits))));
  set_word(Register::position, dynamixel::ticks_of(angle_rad_));
  set_word(Register::speed,
           static_cast<std::uint16_t>(speed | (speed_rad_s_ < 0.0 ? kClockwise : 0U)));
  registers_[Register::moving] = speed_rad_s_ != 0.0 ? 1 : 0;
}

void ServoModel::step(double dt_s) {
  const double wanted = wanted_rad(dt_s);
  const bool pushes = wanted != 0.0 && blocked;
  const double way = blocked ? 0.0 : wanted;
  angle_rad_ += way;
  speed_rad_s_ = way / dt_s;
  set_word(Register::load,
           pushes ? static_cast<std::uint16_t>(kBlockedLoad | (wanted < 0.0 ? kClockwise : 0)) : 0);
  watch_limits(pushes, dt_s);
  tell();
}

}  // namespace striate::pioneer
