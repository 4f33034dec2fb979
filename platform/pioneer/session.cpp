#include "striate/platform/pioneer/session.hpp"

#include <algorithm>

namespace striate::pioneer {

using arcos::Command;
using arcos::command;

namespace {

/// As ARIA asks again for a CONFIGpac
constexpr Duration kConfigAgain = std::chrono::milliseconds(200);
/// As ARIA waits for a CONFIGpac; then it goes on without
constexpr Duration kConfigPatience = std::chrono::milliseconds(1000);
/// Five SIP cycles without one: OPEN was lost
constexpr Duration kAskToOpenAgain = std::chrono::milliseconds(500);

/// What the controller answers to each.
Command command_of(RoundTrip::Question question) {
  switch (question) {
    case RoundTrip::Question::encoders:
      return Command::encoder;
    case RoundTrip::Question::joystick:
      return Command::joystick_info;
    case RoundTrip::Question::io:
      return Command::io_request;
    case RoundTrip::Question::config:
      break;
  }
  return Command::config;
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

void ArcosSession::ask_for_config(TimePoint now) {
  send(command(Command::config, 1));
  round_trip_.asked(RoundTrip::Question::config, now);
  sent_at_ = now;
}

void ArcosSession::measure_the_line(TimePoint now) {
  if (!settings_.echo) return;
  if (const auto question = round_trip_.asks(now)) send(command(command_of(*question), 1));
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

TimePoint ArcosSession::last_state() const {
  return std::max(state_since_, base().stamp);
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
      if (now - sent_at_ >= kAskToOpenAgain) {
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
