#include <cmath>

#include "striate/platform/pioneer/firmware/arcos_firmware.hpp"

/// What ArcosFirmware makes of a connected client's commands.
namespace striate::pioneer {

using arcos::Argument;
using arcos::Command;
using arcos::Packet;

bool ArcosFirmware::handle_motion(const Packet& packet, const Argument& argument) {
  const double heading_deg = degrees(pose_mm().heading_rad);
  const int value = argument.value;
  const bool may_move = motors_on_ && argument.present;
  switch (static_cast<Command>(packet.id)) {
    case Command::move:
      if (may_move) wheels_.move(value);
      return true;
    case Command::rotate:
    case Command::rotation_velocity:
      if (may_move) wheels_.set_turn(value);
      return true;
    case Command::velocity:
      if (may_move) wheels_.set_forward(value);
      return true;
    case Command::heading:
      if (may_move) wheels_.head_for(value);
      return true;
    case Command::turn:
      if (may_move) wheels_.turn_by(value, heading_deg);
      return true;
    case Command::turn_on:
      if (may_move) wheels_.turn_on(value, heading_deg);
      return true;
    case Command::wheels:
      if (may_move) {
        wheels_.set_wheels(static_cast<std::int8_t>(argument.high) * arcos::kWheelUnitMm_s,
                           static_cast<std::int8_t>(argument.low) * arcos::kWheelUnitMm_s,
                           model_.half_axle_mm);
      }
      return true;
    case Command::stop:
      wheels_.stop();
      return true;
    case Command::emergency_stop:
    case Command::quick_stop:
      wheels_.emergency_stop();
      return true;
    default:
      return false;
  }
}

void ArcosFirmware::handle_setting(const Packet& packet, const Argument& argument) {
  WheelControl::Limits& limits = wheels_.limits();
  const double size = std::abs(argument.value);
  const bool negative = argument.value < 0;
  switch (static_cast<Command>(packet.id)) {
    case Command::set_acceleration:
      if (size > 0) (negative ? limits.deceleration_mm_s2 : limits.acceleration_mm_s2) = size;
      return;
    case Command::set_velocity:
      if (argument.present) limits.forward_mm_s = size;
      return;
    case Command::set_rotation:
      if (argument.present) limits.turn_deg_s = size;
      return;
    case Command::set_rotation_acceleration:
      if (size > 0) {
        (negative ? limits.turn_deceleration_deg_s2 : limits.turn_acceleration_deg_s2) = size;
      }
      return;
    case Command::enable:
      set_motors(argument.value != 0);
      return;
    case Command::set_origin:
      origin_ = senses_.odometry.pose;
      return;
    case Command::sonar:
      sonar_on_ = (argument.value & 1) != 0;
      return;
    case Command::joystick_drive:
      joystick_allowed_ = argument.value != 0;
      return;
    case Command::emergency_stall:
      wheels_.emergency_stop();
      set_motors(false);
      return;
    case Command::battery_test:
      if (argument.present) fake_battery_v_ = argument.value / 10.0;
      return;
    default:
      return;
  }
}

void ArcosFirmware::handle_request(const Packet& packet, const Argument& argument) {
  switch (static_cast<Command>(packet.id)) {
    case Command::close:
      close();
      return;
    case Command::config:
      send_config();
      return;
    case Command::joystick_info:
      joystick_stream_ = argument.value;
      if (joystick_stream_ == 1) send(arcos::write_joystick(senses_.joystick));
      return;
    case Command::encoder:
      encoder_stream_ = argument.value;
      if (encoder_stream_ == 1) send_encoders();
      return;
    case Command::io_request:
      if (argument.value == 1) send(arcos::write_io());
      return;
    case Command::laser_mode:
      laser_wanted_ = argument.value != 0;
      return;
    case Command::sim_stat:
      if (argument.value == 0) return;  // simulators answer only with an argument
      send(arcos::write_sim_stat(
          {static_cast<std::int32_t>(std::lround(1000.0 * senses_.true_pose.x_m)),
           static_cast<std::int32_t>(std::lround(1000.0 * senses_.true_pose.y_m)),
           static_cast<std::int32_t>(std::lround(degrees(senses_.true_pose.heading_rad)))}));
      return;
    default:
      return;  // unknown commands are ignored
  }
}

}  // namespace striate::pioneer
