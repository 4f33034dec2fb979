#include "striate/platform/pioneer/firmware/urg_device.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>

/// States and replies are those of Hokuyo's "Communication Protocol Specification for SCIP2.0"
/// (C-42-03320B).
namespace striate::pioneer {
namespace {

/// Characters of a command: MD's 15, ';' and 16 of the client's (C-42-03320B); ours is twice that
constexpr std::size_t kLongestCommand = 64;
constexpr std::size_t kMostTail = 16;  // characters behind ';'; C-42-03320B
/// A level of CR is a hundredth of the speed: which, the specification leaves open (ours)
constexpr int kSlowerShare = 100;
constexpr int kMostSlower = 10;  // levels of CR; C-42-03320B
/// Within so long of the first RB the second one reboots; SCIP 2.2
constexpr Duration kRebootWithin = std::chrono::seconds(1);
/// Of GD that wait for the mirror: more than a turn's worth of commands is not kept (ours)
constexpr std::size_t kMostScansAsked = 8;

/// Of a command: characters of its parameters; C-42-03320B.
struct KnownCommand {
  const char* name;
  std::size_t parameters;
};
constexpr KnownCommand kCommands[] = {
    {"VV", 0}, {"PP", 0}, {"II", 0}, {"BM", 0},  {"QT", 0},  {"RS", 0},  {"RB", 0},  {"TM", 1},
    {"HS", 1}, {"CR", 2}, {"SS", 6}, {"GD", 10}, {"GS", 10}, {"MD", 13}, {"MS", 13},
};

/// -1: not all of it is digits.
int decimal_of(const std::string& text) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool all = error == std::errc{} && end == text.data() + text.size() && text[0] != '-';
  return all ? value : -1;
}

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

std::vector<std::string> UrgDevice::info_of(const std::string& kind) const {
  const scip::Parameters& p = parameters_;
  if (kind == "VV") {
    return {"VEND:Striate", "PROD:SOKUIKI Sensor " + p.model, "FIRM:3.3.00", "PROT:SCIP 2.0",
            "SERI:SIM"};
  }
  const auto text = [](const char* key, int value) { return key + std::to_string(value); };
  if (kind == "PP") {
    return {"MODL:" + p.model,
            text("DMIN:", p.nearest_mm),
            text("DMAX:", p.farthest_mm),
            text("ARES:", p.steps_a_turn),
            text("AMIN:", p.first_step),
            text("AMAX:", p.last_step),
            text("AFRT:", p.front_step),
            text("SCAN:", p.rpm)};
  }
  const int rpm = p.rpm - p.rpm * slower_ / kSlowerShare;
  return {"MODL:" + p.model,
          fmt::format("LASR:{}", laser_on_ ? "ON" : "OFF"),
          fmt::format("SCSP:{}({}[rpm])", slower_ == 0 ? "Initial" : "Set", rpm),
          fmt::format("MESM:{}", running_ ? "Measuring" : "IDLE"),
          fmt::format("SBPS:{}[bps]", bit_rate_),
          fmt::format("TIME:{:06X}", shown_ms()),
          "STAT:Sensor works well."};
}

std::string UrgDevice::switch_state(const std::string& kind, const std::string& parameter) {
  if (kind == "TM") return set_clock_mode(parameter[0]);
  if (kind == "CR") return set_speed(parameter);
  if (kind == "SS") return set_bit_rate(parameter);
  if (kind == "RB") return ask_reboot();
  if (kind == "HS") {
    if (parameter != "0" && parameter != "1") return "01";
    const bool was = std::exchange(sensitive_, parameter == "1");
    return was == sensitive_ ? "02" : "00";
  }
  if (kind == "BM") {
    if (clock_mode_) return "0B";
    return std::exchange(laser_on_, true) ? "02" : "00";
  }
  laser_off();
  if (kind == "RS") {
    slower_ = 0;
    bit_rate_ = kBitRate;
    clock_mode_ = sensitive_ = false;
    zero_ = now_;
  }
  return "00";
}

std::string UrgDevice::set_clock_mode(char mode) {
  if (mode == '0') {
    laser_off();
    return std::exchange(clock_mode_, true) ? "02" : "00";
  }
  if (mode == '2') return std::exchange(clock_mode_, false) ? "00" : "03";
  return mode == '1' ? "04" : "01";
}

std::string UrgDevice::set_speed(const std::string& level) {
  int value = decimal_of(level);
  if (value < 0) return "01";
  if (value == 99) value = 0;  // the initial speed
  if (value > kMostSlower) return "02";
  return std::exchange(slower_, value) == value ? "03" : "00";
}

std::string UrgDevice::set_bit_rate(const std::string& rate) {
  constexpr std::array kRates{19200, 38400, 57600, 115200, 250000, 500000, 750000};
  const int value = decimal_of(rate);
  if (value < 0) return "01";
  if (std::find(kRates.begin(), kRates.end(), value) == kRates.end()) return "02";
  return std::exchange(bit_rate_, value) == value ? "03" : "00";
}

std::string UrgDevice::ask_reboot() {
  const bool again = reboot_asked_ && now_ - *reboot_asked_ <= kRebootWithin;
  if (!again) {
    reboot_asked_ = now_;
    return "01";
  }
  Bytes said = std::exchange(output_, {});
  reboot();
  output_ = std::move(said);
  return "00";
}

/// @returns the status to say; empty: a GD or GS, whose reply comes with the scan
std::string UrgDevice::ask_scans(const std::string& body, const std::string& tail) {
  const bool endless = body[0] == 'M';
  Scans scans{endless ? body.substr(0, 13) : body, tail, {}};
  scip::ScanRequest& request = scans.request;
  request.three_characters = body[1] == 'D';
  request.first_step = decimal_of(body.substr(2, 4));
  request.last_step = decimal_of(body.substr(6, 4));
  request.group = decimal_of(body.substr(10, 2));
  if (request.first_step < 0) return "01";
  if (request.last_step < 0) return "02";
  if (request.group < 0) return "03";
  if (request.last_step > parameters_.last_step) return "04";
  if (request.last_step < request.first_step) return "05";
  // Steps that it does not measure: the specification has no status of its own for the first one.
  if (request.first_step < parameters_.first_step) return "04";
  request.group = std::max(1, request.group);
  if (clock_mode_) return "0B";
  if (!endless) {
    if (!laser_on_) return "10";
    if (asked_.size() >= kMostScansAsked) return "0B";
    asked_.push_back(std::move(scans));
    return {};
  }
  request.skip = decimal_of(body.substr(12, 1));
  request.count = decimal_of(body.substr(13, 2));
  if (request.skip < 0) return "06";
  if (request.count < 0) return "07";
  laser_on_ = true;
  next_scan_ = std::min(next_scan_, now_ + turn());  // whatever an earlier one skipped
  running_ = std::move(scans);
  return "00";
}

Duration UrgDevice::turn() const {
  const double rpm = parameters_.rpm * (1.0 - static_cast<double>(slower_) / kSlowerShare);
  return from_seconds(60.0 / rpm);
}

int UrgDevice::shown_ms() const {
  const auto time_ms = std::chrono::duration_cast<std::chrono::milliseconds>(now_ - zero_).count();
  return static_cast<int>(time_ms & 0xffffff);
}

std::vector<int> UrgDevice::grouped(const scip::ScanRequest& request,
                                    const std::vector<int>& ranges_mm) const {
  std::vector<int> nearest;
  for (int at = request.first_step; at <= request.last_step; at += request.group) {
    const auto begin = ranges_mm.begin() + (at - parameters_.first_step);
    const int size = std::min(request.group, request.last_step - at + 1);
    // Below the nearest range stand the codes of rays that measured nothing: they hide nothing.
    int least = 0;
    for (auto range = begin; range != begin + size; ++range) {
      const bool measured = *range >= parameters_.nearest_mm;
      if (measured && (least < parameters_.nearest_mm || *range < least)) least = *range;
    }
    nearest.push_back(least);
  }
  return nearest;
}

void UrgDevice::step(TimePoint now, const std::vector<int>& ranges_mm) {
  now_ = now;
  if (ranges_mm.size() < rays()) return;
  const auto send = [&](const Scans& scans, const std::string& echo) {
    const std::string text =
        scip::write_reply(scip::write_scan(echo, shown_ms(), grouped(scans.request, ranges_mm),
                                           scans.request.three_characters ? 3 : 2));
    output_.insert(output_.end(), text.begin(), text.end());
  };
  if (!asked_.empty() && now >= next_turn_) {
    for (const Scans& scans : asked_) send(scans, scans.head + scans.tail);
    asked_.clear();
    next_turn_ = now + turn();
  }
  if (!running_ || now < next_scan_) return;
  scip::ScanRequest& request = running_->request;
  next_scan_ = now + turn() * (request.skip + 1);
  const bool counted = request.count > 0;
  if (counted) --request.count;
  send(*running_, running_->head + fmt::format("{:02}", request.count) + running_->tail);
  if (counted && request.count == 0) laser_off();
}

}  // namespace striate::pioneer
