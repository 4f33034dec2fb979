#include <algorithm>

#include "striate/platform/pioneer/session.hpp"

/// What an ArcosSession makes of the packets that come.
namespace striate::pioneer {

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

}  // namespace striate::pioneer
