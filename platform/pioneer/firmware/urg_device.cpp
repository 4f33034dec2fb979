#include "striate/platform/pioneer/firmware/urg_device.hpp"

#include <algorithm>

namespace striate::pioneer {
namespace {

/// Between scans: URG-04LX, 600 rpm (SCAN of its PP reply)
constexpr Duration kTurnOfUrg = std::chrono::milliseconds(100);
constexpr std::size_t kLongestLine = 64;  // SCIP 2.0: data comes in lines of 64 characters

}  // namespace

void UrgDevice::say(const scip::Reply& reply, bool info) {
  const std::string text = scip::write_reply(reply, info);
  append(output_, Bytes(text.begin(), text.end()));
}

Bytes UrgDevice::take_output() {
  Bytes bytes;
  bytes.swap(output_);
  return bytes;
}

void UrgDevice::reboot() {
  laser_on_ = false;
  running_.reset();
  line_.clear();
  output_.clear();
}

void UrgDevice::receive(ByteView bytes) {
  for (const std::uint8_t byte : bytes) {
    if (byte == '\n' || byte == '\r') {
      if (!line_.empty()) obey(line_);
      line_.clear();
    } else if (line_.size() < kLongestLine) {
      line_.push_back(static_cast<char>(byte));
    }
  }
}

void UrgDevice::obey(const std::string& line) {
  const std::string kind = line.substr(0, 2);
  const auto text = [](const char* key, int value) { return key + std::to_string(value); };
  if (kind == "BM") {
    say({line, laser_on_ ? "02" : "00", {}});
    laser_on_ = true;
  } else if (kind == "QT" || kind == "RS") {
    laser_on_ = false;
    running_.reset();
    say({line, "00", {}});
  } else if (kind == "VV") {
    say({line, "00", {"VEND:Striate", "PROD:URG-04LX", "FIRM:1", "PROT:SCIP 2.0", "SERI:SIM"}},
        true);
  } else if (kind == "PP") {
    const scip::Parameters& p = parameters_;
    say({line,
         "00",
         {"MODL:" + p.model, text("DMIN:", p.nearest_mm), text("DMAX:", p.farthest_mm),
          text("ARES:", p.steps_a_turn), text("AMIN:", p.first_step), text("AMAX:", p.last_step),
          text("AFRT:", p.front_step), text("SCAN:", p.rpm)}},
        true);
  } else if (kind == "MD" || kind == "MS") {
    start_scanning(line);
  } else if (line.rfind("TM1", 0) == 0) {
    say(scip::write_time(line, shown_ms()));
  } else if (kind == "SC" || kind == "CR" || kind == "SS" || kind == "HS" || kind == "TM") {
    say({line, "00", {}});
  } else {
    say({line, "0E", {}});
  }
}

void UrgDevice::start_scanning(const std::string& line) {
  const auto request = scip::read_request(line);
  const bool fits = request && request->first_step >= parameters_.first_step &&
                    request->last_step <= parameters_.last_step;
  if (!fits) {
    say({line, "05", {}});
    return;
  }
  laser_on_ = true;
  running_ = request;
  say({line, "00", {}});
}

int UrgDevice::shown_ms() const {
  const auto time_ms =
      std::chrono::duration_cast<std::chrono::milliseconds>(now_.time_since_epoch()).count();
  return static_cast<int>(time_ms & 0xffffff);
}

void UrgDevice::step(TimePoint now, const std::vector<int>& ranges_mm) {
  now_ = now;
  if (!running_ || now < next_scan_ || ranges_mm.size() < rays()) return;
  next_scan_ = now + kTurnOfUrg * (running_->skip + 1);
  const bool counted = running_->count > 0;
  if (counted) --running_->count;
  std::vector<int> grouped;
  for (int at = running_->first_step; at <= running_->last_step; at += running_->group) {
    const auto begin = ranges_mm.begin() + (at - parameters_.first_step);
    const int size = std::min(running_->group, running_->last_step - at + 1);
    grouped.push_back(*std::min_element(begin, begin + size));
  }
  say(scip::write_scan(*running_, shown_ms(), grouped));
  if (counted && running_->count == 0) running_.reset();
}

}  // namespace striate::pioneer
