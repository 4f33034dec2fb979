#include <algorithm>
#include <cmath>

#include "striate/platform/pioneer/session.hpp"

/// The limits of an ArcosSession: of the settings, the model and what the robot itself tells.
namespace striate::pioneer {

using arcos::Command;
using arcos::command;

namespace {

/// 0 in a CONFIGpac means that the firmware does not say.
double least_told(double limit, std::uint16_t told) {
  return told == 0 ? limit : std::min(limit, static_cast<double>(told));
}

int rounded(double value) {
  return static_cast<int>(std::lround(value));
}

}  // namespace

double ArcosSession::most_forward_mm_s() const {
  const double most = std::min(1000.0 * settings_.most_forward_m_s, model_.most_forward_mm_s);
  return config_ ? least_told(most, config_->velocity_top_mm_s) : most;
}

double ArcosSession::most_turn_deg_s() const {
  const double most = std::min(degrees(settings_.most_turn_rad_s), model_.most_turn_deg_s);
  return config_ ? least_told(most, config_->rotation_top_deg_s) : most;
}

double ArcosSession::deceleration_mm_s2() const {
  const double wanted = 1000.0 * settings_.acceleration_m_s2;
  return config_ ? least_told(wanted, config_->acceleration_top_mm_s2) : wanted;
}

void ArcosSession::tell_limits() {
  const double acceleration = deceleration_mm_s2();
  double turn = degrees(settings_.turn_acceleration_rad_s2);
  if (config_) turn = least_told(turn, config_->rotation_acceleration_top_deg_s2);
  send(command(Command::set_velocity, rounded(most_forward_mm_s())));
  send(command(Command::set_acceleration, rounded(acceleration)));
  send(command(Command::set_acceleration, -rounded(acceleration)));
  send(command(Command::set_rotation, rounded(most_turn_deg_s())));
  send(command(Command::set_rotation_acceleration, rounded(turn)));
  send(command(Command::set_rotation_acceleration, -rounded(turn)));
  send(command(Command::joystick_drive, settings_.joystick_may_drive ? 1 : 0));
}

}  // namespace striate::pioneer
