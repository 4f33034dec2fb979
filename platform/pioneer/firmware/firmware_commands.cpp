#include <algorithm>
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
  constexpr WheelControl::Limits kTop = WheelControl::kTop;
  const double size = std::abs(argument.value);
  const bool negative = argument.value < 0;
  switch (static_cast<Command>(packet.id)) {
    case Command::set_acceleration:
      if (size > 0) {
        (negative ? limits.deceleration_mm_s2 : limits.acceleration_mm_s2) =
            std::min(size, kTop.acceleration_mm_s2);
      }
      return;
    case Command::set_velocity:
      if (argument.present) limits.forward_mm_s = std::min(size, kTop.forward_mm_s);
      return;
    case Command::set_rotation:
      if (argument.present) limits.turn_deg_s = std::min(size, kTop.turn_deg_s);
      return;
    case Command::set_rotation_acceleration:
      if (size > 0) {
        (negative ? limits.turn_deceleration_deg_s2 : limits.turn_acceleration_deg_s2) =
            std::min(size, kTop.turn_acceleration_deg_s2);
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
      fake_battery_v_.reset();  // without a value, or with 0, it is the battery's own again
      if (argument.value > 0) fake_battery_v_ = argument.value / 10.0;
      return;
    default:
      return;
  }
}

void ArcosFirmware::handle_request(const Packet& packet, const Argument& argument) {
  switch (static_cast<Command>(packet.id)) {
    case Command::close:
    case Command::reset:  // the controller begins anew: no session
      close();
      return;
    case Command::config:
      send_config();
      return;
    case Command::digital_out:
      if (argument.present) {
        digital_out_ = static_cast<std::uint8_t>((digital_out_ & ~argument.high) |
                                                 (argument.low & argument.high));
      }
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

/// Packets that are sent once (1), with each SIP (2), or no more (0).
void ArcosFirmware::handle_stream(const Packet& packet, const Argument& argument) {
  const bool once = argument.value == 1;
  switch (static_cast<Command>(packet.id)) {
    case Command::joystick_info:
      joystick_stream_ = argument.value;
      if (once) send(arcos::write_joystick(senses_.joystick));
      return;
    case Command::encoder:
      encoder_stream_ = argument.value;
      if (once) send_encoders();
      return;
    case Command::io_request:
      io_stream_ = argument.value;
      if (once) send_io();
      return;
    case Command::battery_info:
      battery_stream_ = argument.value;
      if (once) send_battery();
      return;
    case Command::gyro:  // never once: it has told nothing then
      gyro_streams_ = argument.value != 0;
      turned_deg_ = 0.0;
      return;
    default:
      return;
  }
}

bool ArcosFirmware::handle_laser(const Packet& packet, const Argument& argument) {
  constexpr int kBehind_deg = 180;  // no reading looks further round
  const int bearing_deg = std::clamp(argument.value, -kBehind_deg, kBehind_deg);
  switch (static_cast<Command>(packet.id)) {
    case Command::laser_mode:
    case Command::sim_laser_mode:
      laser_mode_ = argument.value;
      return true;
    case Command::laser_start:
    case Command::sim_laser_start:
      if (argument.present) laser_field_.start_deg = bearing_deg;
      return true;
    case Command::laser_end:
    case Command::sim_laser_end:
      if (argument.present) laser_field_.end_deg = bearing_deg;
      return true;
    case Command::laser_increment:
    case Command::sim_laser_increment:
      if (argument.value > 0) laser_field_.increment_cdeg = argument.value;
      return true;
    default:
      return false;
  }
}

/// What only a simulated robot's client may do to it.
void ArcosFirmware::handle_simulator(const Packet& packet) {
  switch (static_cast<Command>(packet.id)) {
    case Command::sim_set_pose:
      if (const auto pose = arcos::read_sim_pose(packet)) {
        new_place_ = {pose->x_mm / 1000.0, pose->y_mm / 1000.0,
                      wrap_angle(radians(std::remainder(pose->heading_deg, 360.0)))};
      }
      return;
    case Command::sim_reset:
      new_place_ = start_;
      origin_ = senses_.odometry.pose;
      return;
    default:
      return;
  }
}

}  // namespace striate::pioneer
