#include "striate/platform/pioneer/firmware/urg_device.hpp"

#include <algorithm>

/// States and replies are those of Hokuyo's "Communication Protocol Specification for SCIP2.0"
/// (C-42-03320B).

namespace striate::pioneer {
namespace {

/// Characters of a command: MD's 15, ';' and 16 of the client's (C-42-03320B); ours is twice that
constexpr std::size_t kLongestCommand = 64;
constexpr std::size_t kMostTail = 16;  // characters behind ';'; C-42-03320B

/// Of a command: characters of its parameters; C-42-03320B.
struct KnownCommand {
  const char* name;
  std::size_t parameters;
};

constexpr KnownCommand kCommands[] = {
    {"VV", 0}, {"PP", 0}, {"II", 0}, {"BM", 0},  {"QT", 0},  {"RS", 0},  {"RB", 0},  {"TM", 1},
    {"HS", 1}, {"CR", 2}, {"SS", 6}, {"GD", 10}, {"GS", 10}, {"MD", 13}, {"MS", 13},
};

bool printable(const std::string& text) {
  return std::all_of(text.begin(), text.end(), [](char c) { return c >= ' ' && c <= '~'; });
}

}  // namespace

void UrgDevice::say(const std::string& echo, const std::string& status,
                    const std::vector<std::string>& info) {
  const std::string text = scip::write_reply({echo, status, info}, true);
  output_.insert(output_.end(), text.begin(), text.end());
}

Bytes UrgDevice::take_output() {
  Bytes bytes;
  bytes.swap(output_);
  return bytes;
}

void UrgDevice::laser_off() {
  laser_on_ = false;
  running_.reset();
  asked_.clear();
}

void UrgDevice::reboot() {
  const std::uint64_t understood = understood_;
  const TimePoint now = now_;
  *this = UrgDevice();
  understood_ = understood;
  now_ = zero_ = now;
}

void UrgDevice::receive(ByteView bytes) {
  for (const std::uint8_t byte : bytes) {
    if (byte == '\n' || byte == '\r') {
      if (!line_.empty()) take_line();
      line_.clear();
    } else if (line_.size() <= kLongestCommand) {
      line_.push_back(static_cast<char>(byte));
    }
  }
}

void UrgDevice::take_line() {
  if (!printable(line_)) return;  // noise of a line, or another device's protocol
  const std::size_t semicolon = std::min(line_.find(';'), line_.size());
  const std::string body = line_.substr(0, semicolon);
  if (line_.size() - semicolon > kMostTail + 1) {
    say(line_, "0G");
  } else {
    obey(body, line_.substr(semicolon));
  }
}

void UrgDevice::obey(const std::string& body, const std::string& tail) {
  const std::string echo = body + tail;
  if (body == "SCIP2.0") {  // it speaks it already
    ++understood_;
    return say(echo, "00");
  }
  const std::string kind = body.substr(0, 2);
  const auto* known = std::find_if(std::begin(kCommands), std::end(kCommands),
                                   [&](const KnownCommand& each) { return kind == each.name; });
  if (known == std::end(kCommands)) return say(echo, "0E");
  const std::size_t given = body.size() - 2;
  if (given != known->parameters) return say(echo, given < known->parameters ? "0C" : "0E");
  ++understood_;
  if (kind == "TM" && body[2] == '1' && clock_mode_) {
    const std::string text = scip::write_reply(scip::write_time(echo, shown_ms()));
    output_.insert(output_.end(), text.begin(), text.end());
  } else if (kind == "VV" || kind == "PP" || kind == "II") {
    say(echo, "00", info_of(kind));
  } else if (known->parameters >= 10) {
    const std::string status = ask_scans(body, tail);
    if (!status.empty()) say(echo, status);
  } else {
    say(echo, switch_state(kind, body.substr(2)));
  }
}

int UrgDevice::shown_ms() const {
  const auto time_ms = std::chrono::duration_cast<std::chrono::milliseconds>(now_ - zero_).count();
  return static_cast<int>(time_ms & 0xffffff);
}

}  // namespace striate::pioneer
