#include "striate/platform/pioneer/firmware/servo_model.hpp"

namespace striate::pioneer {

using dynamixel::Error;
using dynamixel::Register;
namespace {

/// Locked, only addresses 18 to 23 (hex) may be written; AX-12 manual, example 20
constexpr std::uint8_t kLastUnlocked = 0x23;

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
    const unsigned most = turns ? dynamixel::kClockwise | dynamixel::kSizeBits : place->most;
    if (locked || value < place->least || value > most) return Error::range;
    const bool outside = value < word(Register::cw_limit) || value > word(Register::ccw_limit);
    if (place->address == Register::goal_position && outside && !has_no_limits()) {
      return Error::angle_limit;
    }
    at += place->size;
  }
  return 0;
}

}  // namespace striate::pioneer
