#include "striate/platform/pioneer/session.hpp"

#include <algorithm>
#include <cmath>

namespace striate::pioneer {

using arcos::Command;
using arcos::command;

namespace {

/// As ARIA asks again for a CONFIGpac
constexpr Duration kConfigAgain = std::chrono::milliseconds(200);
/// As ARIA waits for a CONFIGpac; then it goes on without
constexpr Duration kConfigPatience = std::chrono::milliseconds(1000);
/// Five SIP cycles without one: OPEN was lost
constexpr Duration kOpenAgain = std::chrono::milliseconds(500);

/// 0 in a CONFIGpac means that the firmware does not say.
double least_told(double limit, std::uint16_t told) {
  return told == 0 ? limit : std::min(limit, static_cast<double>(told));
}

int rounded(double value) {
  return static_cast<int>(std::lround(value));
}

}  // namespace

const char* name_of(LinkState state) {
  switch (state) {
    case LinkState::waiting:
      return "waiting";
    case LinkState::syncing:
      return "syncing";
    case LinkState::opening:
      return "opening";
    case LinkState::configuring:
      return "configuring";
    case LinkState::ready:
      return "ready";
    case LinkState::closed:
      return "closed";
    case LinkState::refused:
      return "refused";
  }
  return "";
}

bool ArcosSession::wants_line(TimePoint now) const {
  switch (state_) {
    case LinkState::closed:
    case LinkState::refused:
      return false;
    case LinkState::waiting:
      return now >= open_again_at_;
    default:
      return true;
  }
}

void ArcosSession::line_up(TimePoint now) {
  if (line_is_up_ || state_ == LinkState::closed || state_ == LinkState::refused) return;
  line_is_up_ = true;
  restarts_ = 0;
  last_packet_ = now;
  begin_sync(now);
}

void ArcosSession::line_down(TimePoint now) {
  line_is_up_ = false;
  if (state_ == LinkState::closed || state_ == LinkState::refused) return;
  if (state_ == LinkState::waiting && now < open_again_at_) return;
  lose(now, "the link is down");
}

void ArcosSession::lose(TimePoint now, const std::string& why) {
  trouble_ = why;
  output_.clear();
  if (state_ == LinkState::ready) send(command(Command::stop));  // should it still be heard
  state_ = LinkState::waiting;
  state_since_ = now;
  stream_.clear();
  incomplete_ = false;
  line_is_up_ = false;
  back_off_s_ = std::clamp(2.0 * back_off_s_, settings_.back_off_s, settings_.longest_back_off_s);
  open_again_at_ = now + from_seconds(back_off_s_);
}

void ArcosSession::receive(ByteView bytes, TimePoint now) {
  stream_.push(bytes);
  // A packet's time is that of its first byte, which may have come with an earlier chunk.
  TimePoint began = incomplete_ ? incomplete_since_ : now;
  while (const auto packet = stream_.next()) {
    handle(*packet, began);
    began = now;
  }
  incomplete_ = stream_.waiting();
  incomplete_since_ = began;
}

void ArcosSession::handle(const arcos::Packet& packet, TimePoint now) {
  last_packet_ = std::max(last_packet_, now);
  switch (state_) {
    case LinkState::syncing:
      handle_syncing(packet, now);
      return;
    case LinkState::opening:
    case LinkState::configuring:
    case LinkState::ready:
      handle_open(packet, now);
      return;
    default:
      return;
  }
}

void ArcosSession::handle_open(const arcos::Packet& packet, TimePoint now) {
  if (arcos::is_sip(packet)) {
    take_sip(packet, now);
    return;
  }
  if (packet.id == arcos::Encoders::kId) {
    round_trip_.answered(RoundTrip::Question::encoders, now);
    return;
  }
  if (packet.id == arcos::IoPac::kId) {
    round_trip_.answered(RoundTrip::Question::io, now);
    return;
  }
  if (packet.id == arcos::ConfigPac::kId) {
    round_trip_.answered(RoundTrip::Question::config, now);
    config_ = arcos::read_config_pac(packet);
    if (config_) {
      tracker_.use_bumpers(config_->front_bumpers != 0, config_->rear_bumpers != 0);
      if (state_ == LinkState::configuring) get_ready(now);
      return;
    }
  } else if (packet.id == arcos::Joystick::kId) {
    if (const auto joystick = arcos::read_joystick(packet)) {
      round_trip_.answered(RoundTrip::Question::joystick, now);
      tracker_.take_joystick(joystick->button1);
      return;
    }
  } else if (packet.id == arcos::SimLaser::kId) {
    if (const auto part = arcos::read_sim_laser(packet)) {
      if (sweep_.take(*part)) tracker_.take_laser(sweep_.ranges_mm(), now);
      return;
    }
  } else if (packet.id == arcos::SimStat::kId) {
    true_pose_ = arcos::read_sim_stat(packet);
    if (true_pose_) return;
  } else {
    ++counters_.unknown;
    counters_.last_unknown_id = packet.id;
    return;
  }
  ++counters_.malformed;
  counters_.last_malformed_id = packet.id;
}

void ArcosSession::take_sip(const arcos::Packet& packet, TimePoint now) {
  const auto sip = arcos::read_sip(packet);
  if (!sip) {
    ++counters_.malformed;
    counters_.last_malformed_id = packet.id;
    return;
  }
  ++counters_.sips;
  tracker_.take(*sip, now);
  if (state_ != LinkState::opening) return;
  state_ = LinkState::configuring;
  state_since_ = now;
  round_trip_.begin(now);
  ask_for_config(now);
}

void ArcosSession::ask_for_config(TimePoint now) {
  send(command(Command::config, 1));
  round_trip_.asked(RoundTrip::Question::config, now);
  sent_at_ = now;
}

void ArcosSession::measure_the_line(TimePoint now) {
  if (!settings_.echo) return;
  const auto question = round_trip_.asks(now);
  if (!question) return;
  switch (*question) {
    case RoundTrip::Question::encoders:
      send(command(Command::encoder, 1));
      return;
    case RoundTrip::Question::joystick:
      send(command(Command::joystick_info, 1));
      return;
    case RoundTrip::Question::io:
      send(command(Command::io_request, 1));
      return;
    case RoundTrip::Question::config:
      send(command(Command::config, 1));
      return;
  }
}

void ArcosSession::get_ready(TimePoint now) {
  state_ = LinkState::ready;
  state_since_ = now;
  ++counters_.connections;
  back_off_s_ = 0.0;
  trouble_.clear();
  tell_limits();
  ask_for_laser();
}

void ArcosSession::ask_for_laser() {
  const bool simulated = config_ && config_->serial == "SIM";
  if (!simulated || !settings_.simulated_laser) return;
  send(command(Command::laser_start, -90));
  send(command(Command::laser_end, 90));
  send(command(Command::laser_increment, 100));  // 0.01 deg
  send(command(Command::laser_mode, 2));
}

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

TimePoint ArcosSession::last_state() const {
  return std::max(state_since_, base().stamp);
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

void ArcosSession::tick(TimePoint now) {
  if (incomplete_ && now - incomplete_since_ > arcos::kLongestPacket) {
    stream_.give_up_waiting();
    incomplete_ = false;
    receive({}, now);
  }
  switch (state_) {
    case LinkState::syncing:
      tick_syncing(now);
      return;
    case LinkState::opening:
      if (now - sent_at_ >= kOpenAgain) {
        send(command(Command::open, 1));
        sent_at_ = now;
      }
      break;
    case LinkState::configuring:
      if (now - state_since_ >= kConfigPatience) {
        get_ready(now);  // older firmware has no CONFIGpac
      } else if (now - sent_at_ >= kConfigAgain) {
        ask_for_config(now);
      }
      break;
    case LinkState::ready:
      measure_the_line(now);
      break;
    default:
      return;
  }
  if (now - last_packet_ > from_seconds(settings_.lost_after_s)) {
    lose(now, "the robot has fallen silent");
  }
}

void ArcosSession::close() {
  if (state_ == LinkState::closed) return;
  const bool open = state_ == LinkState::opening || state_ == LinkState::configuring ||
                    state_ == LinkState::ready;
  if (open) {
    send(command(Command::stop));
    send(command(Command::enable, 0));
    send(command(Command::close, 1));
  }
  state_ = LinkState::closed;
}

Bytes ArcosSession::take_output() {
  Bytes bytes;
  bytes.swap(output_);
  return bytes;
}

LinkCounters ArcosSession::counters() const {
  LinkCounters counters = counters_;
  counters.stream = stream_.counters();
  return counters;
}

void ArcosSession::ask_true_pose() {
  if (state_ == LinkState::ready) send(command(Command::sim_stat, 1));
}

}  // namespace striate::pioneer
