#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "striate/platform/pioneer/firmware/urg_device.hpp"

/// States and replies are those of Hokuyo's "Communication Protocol Specification for SCIP2.0"
/// (C-42-03320B).

namespace striate::pioneer {
namespace {

constexpr int kMostSlower = 10;  // levels of CR; C-42-03320B
/// Within so long of the first RB the second one reboots; SCIP 2.2
constexpr Duration kRebootWithin = std::chrono::seconds(1);

}  // namespace

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
  int value = scip::decimal_of(level);
  if (value < 0) return "01";
  if (value == 99) value = 0;  // the initial speed
  if (value > kMostSlower) return "02";
  return std::exchange(slower_, value) == value ? "03" : "00";
}

std::string UrgDevice::set_bit_rate(const std::string& rate) {
  constexpr std::array kRates{19200, 38400, 57600, 115200, 250000, 500000, 750000};
  const int value = scip::decimal_of(rate);
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

}  // namespace striate::pioneer
