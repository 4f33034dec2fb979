#include "striate/platform/remote/command_gate.hpp"

#include "striate/platform/remote/hold_reason.hpp"

namespace striate::remote {
namespace {

/// Two leases: to hear, to begin and to tell of it (ours)
constexpr Duration kFollowsWithin = std::chrono::seconds(1);

}  // namespace

CommandGate::CommandGate(const RemoteSettings& settings)
    : settings_(settings),
      lease_(from_seconds(settings.lease_s)),
      gaps_(from_seconds(settings.longest_gap_s), from_seconds(settings.command_gap_s)),
      echo_(kFollowsWithin) {}

void CommandGate::command(const MotorCommand& command, TimePoint now) {
  gaps_.commanded(command, now);
  lease_.give(command, now);
  drives_ = true;
}

void CommandGate::end(TimePoint now) {
  lease_.end();
  gaps_.commanded({}, now);
}

std::string CommandGate::hold_reason(const Inbox& inbox, const std::string& line,
                                     TimePoint now) const {
  if (gaps_.holds()) return "the program stood still";
  if (echo_.holds()) return "the robot does not follow its commands, or is late";
  if (!line.empty()) return line;
  if (line_broke_) return "the line to the robot broke";
  std::string reason = stale_sense(inbox, from_seconds(settings_.stale_s), now);
  if (!reason.empty()) return reason;
  if (!lease_.at(now)) return "no fresh command";
  if (seen_at_ && now - *seen_at_ > from_seconds(settings_.seen_old_s)) {
    return "what it has seen is too old";
  }
  return {};
}

std::optional<MotorCommand> CommandGate::tell(const Inbox& inbox, const std::string& line,
                                              TimePoint now) {
  if (!drives_) return std::nullopt;
  gaps_.look(now);
  const bool holds = !hold_reason(inbox, line, now).empty();
  const MotorCommand told = holds ? MotorCommand{} : *lease_.at(now);
  echo_.felt(inbox.senses().odometry);
  echo_.commanded(told, now);
  return told;
}

void CommandGate::reset() {
  gaps_.reset();
  echo_.reset();
  line_broke_ = false;
  lease_.end();  // what was decided before does not drive
}

}  // namespace striate::remote
