#include <algorithm>
#include <cmath>
#include <numbers>

#include "striate/base/pioneer_devices.hpp"
#include "striate/platform/pioneer/firmware/servo_model.hpp"

namespace striate::pioneer {

using dynamixel::Error;
using dynamixel::Register;
namespace {

/// AX-12A data sheet: 59 rpm without load
constexpr double kFastestRad_s = 59.0 * 2.0 * std::numbers::pi / 60.0;
/// Blocked for so long it gives up, as an AX-12A does after some seconds (ours)
constexpr double kOverloadAfter_s = 2.0;
constexpr double kServoThere_rad = 0.003;  // half a step of the position, 0.293 deg
/// 98 % of the most: what a servo tells that pushes against something (ours)
constexpr std::uint16_t kBlockedLoad = 1000;
/// Half of the 300 degrees that it can tell; in wheel mode a turret's cables end there, too (ours)
constexpr double kEnd_rad = 150.0 * std::numbers::pi / 180.0;

}  // namespace

bool ServoModel::has_no_limits() const {
  return word(Register::cw_limit) == 0 && word(Register::ccw_limit) == 0;
}

/// How far it would go within `dt_s`, were nothing in the way.
double ServoModel::wanted_rad(double dt_s) const {
  if (registers_[Register::torque_enable] == 0 || word(Register::torque_limit) == 0) return 0.0;
  const std::uint16_t told = word(Register::moving_speed);
  const double speed_rad_s =
      std::min((told & dynamixel::kSizeBits) * kServoSpeedStep_rad_s, kFastestRad_s);
  if (has_no_limits()) {  // a wheel: 0 stands
    const double way = speed_rad_s * dt_s * ((told & dynamixel::kClockwise) != 0 ? -1.0 : 1.0);
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
  const auto speed = static_cast<std::uint16_t>(std::lround(std::min(
      std::abs(speed_rad_s_) / kServoSpeedStep_rad_s, static_cast<double>(dynamixel::kSizeBits))));
  set_word(Register::position, dynamixel::ticks_of(angle_rad_));
  set_word(Register::speed,
           static_cast<std::uint16_t>(speed | (speed_rad_s_ < 0.0 ? dynamixel::kClockwise : 0U)));
  registers_[Register::moving] = speed_rad_s_ != 0.0 ? 1 : 0;
}

void ServoModel::step(double dt_s) {
  const double wanted = wanted_rad(dt_s);
  const bool pushes = wanted != 0.0 && blocked;
  const double way = blocked ? 0.0 : wanted;
  angle_rad_ += way;
  speed_rad_s_ = way / dt_s;
  set_word(Register::load, pushes ? static_cast<std::uint16_t>(
                                        kBlockedLoad | (wanted < 0.0 ? dynamixel::kClockwise : 0))
                                  : 0);
  watch_limits(pushes, dt_s);
  tell();
}

}  // namespace striate::pioneer
