#include <fmt/format.h>
#include <fmt/ranges.h>

#include "striate/platform/pioneer/session.hpp"

/// The handshake of a ArcosSession: listen, SYNC0, SYNC1, SYNC2, the robot's names.
namespace striate::pioneer {

using arcos::Command;
using arcos::command;

namespace {

/// Two SIP cycles and a half: an open connection has spoken by then
constexpr Duration kListen = std::chrono::milliseconds(250);
/// One SIP cycle and the bytes on the line: what comes later was not closed
constexpr Duration kAfterClose = std::chrono::milliseconds(150);
constexpr int kMostRestarts = 10;  // as ARIA gives up after ten

}  // namespace

void ArcosSession::begin_sync(TimePoint now) {
  state_ = LinkState::syncing;
  state_since_ = now;
  silent_syncs_ = 0;
  // SYNC0 is PULSE to a robot that believes in an older connection, and wakes its old motion; and
  // no other word may come before SYNC0 where there is none. So listen first: the robot of an open
  // connection speaks every 100 ms.
  sync_step_ = -1;
  closing_old_ = false;
  sent_at_ = now;
}

void ArcosSession::send_sync(TimePoint now) {
  send(command(static_cast<Command>(sync_step_)));
  sent_at_ = now;
}

void ArcosSession::handle_syncing(const arcos::Packet& packet, TimePoint now) {
  if (arcos::is_sip(packet)) {
    // It still believes in an older connection: end that one first, then begin again.
    if (sync_step_ >= 0 || !closing_old_ || now - sent_at_ >= kAfterClose) {
      send(command(Command::stop));
      send(command(Command::close, 1));
      closing_old_ = true;
      sync_again(now);
    }
    return;
  }
  if (sync_step_ == 2) {
    if (const auto names = arcos::read_names(packet)) {
      meet(*names, now);
      return;
    }
  }
  if (packet.id == sync_step_ && sync_step_ < 2) {
    silent_syncs_ = 0;
    ++sync_step_;
    send_sync(now);
  } else if (packet.id == 255 || (packet.id <= 2 && packet.id >= sync_step_ && sync_step_ >= 0)) {
    sync_again(now);  // not the step that was asked for; echoes of earlier ones are harmless
  }
}

void ArcosSession::sync_again(TimePoint now) {
  sync_step_ = -1;
  sent_at_ = now;
  if (++restarts_ > kMostRestarts) lose(now, "the robot's handshake does not come to an end");
}

void ArcosSession::meet(const arcos::RobotNames& names, TimePoint now) {
  names_ = names;
  const RobotModel* model = find_model(names.subclass);
  if (model == nullptr && !settings_.force_unknown_model) {
    trouble_ = fmt::format(
        "the robot is a '{}', of which the factors are not known (known: {}); "
        "'force_unknown_model: yes' drives it as a p3dx-sh",
        names.subclass, fmt::join(model_names(), ", "));
    send(command(Command::close, 1));
    state_ = LinkState::refused;
    return;
  }
  model_ = model != nullptr ? *model : *find_model("p3dx-sh");
  tracker_.use(model_);
  tracker_.seed_again();
  config_.reset();
  state_ = LinkState::opening;
  state_since_ = sent_at_ = now;
  send(command(Command::open, 1));
  // The firmware may resume what an older connection wanted: the first word is a stop.
  send(command(Command::stop));
}

void ArcosSession::tick_syncing(TimePoint now) {
  if (sync_step_ < 0) {
    if (now - sent_at_ < (closing_old_ ? kAfterClose : kListen)) return;
  } else {
    if (now - sent_at_ < from_seconds(settings_.sync_wait_s)) return;
    if (++silent_syncs_ >= settings_.sync_tries) {
      lose(now, "the robot does not answer");
      return;
    }
  }
  // An answer that got lost puts the robot a step ahead: always from the start.
  sync_step_ = 0;
  send_sync(now);
}

}  // namespace striate::pioneer
