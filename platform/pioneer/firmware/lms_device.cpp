#include "striate/platform/pioneer/firmware/lms_device.hpp"

#include <algorithm>
#include <string_view>

#include "striate/base/geometry.hpp"

namespace striate::pioneer {
namespace {

constexpr std::uint8_t kTaken = 0x06;     ///< byte before a reply; SICK LMS-200 telegrams
constexpr std::uint8_t kNotTaken = 0x15;  ///< byte before a reply; SICK LMS-200 telegrams
constexpr std::uint8_t kStatus = 0x10;    ///< the laser is in order
/// Between scans: 371 bytes of one take 97 ms at 38400 baud
constexpr Duration kTurn = std::chrono::milliseconds(100);
/// Half a telegram that stays so is none: a scan of 401 values, 812 bytes, takes 211 ms at 38400
/// baud, and nothing that is sent to a laser is as long
constexpr Duration kLongestToLaser = std::chrono::milliseconds(250);
constexpr std::string_view kType =
    "LMS200;30106;V02.10 ";                         // reply to 3A and 90, as ARIA records it
constexpr std::string_view kVersion = "V02.10 ";    // of the firmware, in reply B1
constexpr std::string_view kPassword = "SICK_LMS";  // for mode 00; SICK LMS-200 telegrams
constexpr std::uint8_t kWrong = 0x92;       // reply: not in this mode, or unknown; SICK telegrams
constexpr std::size_t kConfiguration = 32;  // bytes of 77 and 74; SICK LMS-200 telegrams
constexpr std::size_t kUnitAt = 6;          // of the configuration, 1: mm; SICK telegrams, 77
constexpr std::size_t kModeAt = 5;          // of the configuration, measuring mode; SICK telegrams
/// Bytes between B1 and the status byte; SICK LMS-200 telegrams, table 7-34
constexpr std::size_t kStatusSize = 152;

/// Codes of the baud rates in 20 and in the status telegram; SICK LMS-200 telegrams.
struct BaudCode {
  std::uint8_t mode;
  std::uint16_t status;
};
constexpr BaudCode kLaserBauds[] = {{0x42, 0x8067}, {0x41, 0x8033}, {0x40, 0x8019}, {0x48, 0x8001}};

std::uint16_t word_at(const Bytes& data, std::size_t at) {
  return static_cast<std::uint16_t>(data[at] | data[at + 1] << 8U);
}

Bytes text_reply(std::uint8_t kind, std::string_view text) {
  Bytes answer{kind};
  append(answer, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
  return answer;
}

}  // namespace

/// Centimetres; the other values are those of a laser as it is delivered, as ARIA sends them back.
Bytes LmsDevice::factory_configuration() {
  Bytes configuration(kConfiguration, 0);
  configuration[2] = 0x46;  // stop threshold
  configuration[kModeAt] = 5;
  configuration[9] = configuration[10] = 2;
  return configuration;
}

Bytes LmsDevice::take_output() {
  Bytes bytes;
  bytes.swap(output_);
  return bytes;
}

/// The configuration and the baud rate stay: it keeps them without current.
void LmsDevice::reboot() {
  stream_ = lms200::TelegramStream(lms200::kToLaser);
  output_.clear();
  mode_ = kOnRequest;
  installing_ = scanning_ = asked_ = starting_ = false;
  field_deg_ = 180;
  increment_cdeg_ = 100;
}

void LmsDevice::receive(ByteView bytes) {
  if (!bytes.empty()) heard_ = now_;
  stream_.push(bytes);
  obey_all();
}

void LmsDevice::obey_all() {
  while (true) {
    const std::uint64_t bad = stream_.counters().bad_crc;
    const auto telegram = stream_.next();
    if (stream_.counters().bad_crc != bad) output_.push_back(kNotTaken);
    if (!telegram) return;
    obey(*telegram);
  }
}

void LmsDevice::reply(Bytes data) {
  data.push_back(kStatus);
  append(output_, Bytes{kTaken});
  append(output_, lms200::encode({lms200::kFromLaser, std::move(data)}));
}

void LmsDevice::obey(const lms200::Telegram& telegram) {
  const Bytes& data = telegram.data;
  switch (data[0]) {
    case 0x10:
      scanning_ = asked_ = installing_ = false;
      mode_ = kOnRequest;
      starting_ = true;
      return reply({0x91});
    case 0x20:
      return set_mode(data);
    case 0x30:
      if (data.size() != 2 || data[1] != 0x01) return reply({kWrong});
      asked_ = true;
      output_.push_back(kTaken);
      return;
    case 0x31:
      return tell_status();
    case 0x3a:
      return reply(text_reply(0xba, kType));
    case 0x3b:
      return set_variant(data);
    case 0x74: {
      Bytes answer{0xf4};
      append(answer, configuration_);
      return reply(std::move(answer));
    }
    case 0x77:
      return configure(data);
    default:
      return reply({kWrong});
  }
}

void LmsDevice::set_mode(const Bytes& data) {
  const std::uint8_t mode = data.size() > 1 ? data[1] : 0xff;
  const auto* baud = std::find_if(std::begin(kLaserBauds), std::end(kLaserBauds),
                                  [&](const BaudCode& each) { return each.mode == mode; });
  if (baud != std::end(kLaserBauds)) {
    baud_ = mode;
    return reply({0xa0, 0x00});
  }
  const ByteView word = ByteView(data).subspan(std::min<std::size_t>(2, data.size()));
  const bool installs =
      mode == 0x00 && std::equal(word.begin(), word.end(), kPassword.begin(), kPassword.end());
  if (!installs && mode != 0x24 && mode != kOnRequest) return reply({0xa0, 0x01});
  mode_ = mode;
  installing_ = installs;
  scanning_ = mode == 0x24;
  reply({0xa0, 0x00});
}

void LmsDevice::set_variant(const Bytes& data) {
  if (data.size() != 5) return reply({kWrong});
  const int field_deg = word_at(data, 1);
  int increment_cdeg = word_at(data, 3);
  if (increment_cdeg == 0) increment_cdeg = increment_cdeg_;  // ARIA keeps the old one so
  const bool fine = increment_cdeg == 25 && field_deg == 100;
  const bool known = (field_deg == 100 || field_deg == 180) &&
                     (increment_cdeg == 100 || increment_cdeg == 50 || fine);
  if (known) {
    field_deg_ = field_deg;
    increment_cdeg_ = increment_cdeg;
  }
  reply({0xbb, static_cast<std::uint8_t>(known ? 0x01 : 0x00), data[1], data[2], data[3], data[4]});
}

void LmsDevice::configure(const Bytes& data) {
  // Newer firmware has two bytes more, which say nothing of ranges.
  if (!installing_ || data.size() < kConfiguration + 1 || data.size() > kConfiguration + 3) {
    return reply({kWrong});
  }
  configuration_.assign(data.begin() + 1, data.end());
  Bytes answer{0xf7, 0x01};
  append(answer, configuration_);
  reply(std::move(answer));
}

void LmsDevice::tell_status() {
  Bytes told(kStatusSize, 0);
  const auto put_word = [&](std::size_t at, int value) {
    told[at] = static_cast<std::uint8_t>(value & 0xff);
    told[at + 1] = static_cast<std::uint8_t>(value >> 8);
  };
  std::copy(kVersion.begin(), kVersion.end(), told.begin());
  told[7] = mode_;
  told[101] = configuration_[kModeAt];
  put_word(106, field_deg_);
  put_word(108, increment_cdeg_);
  for (const BaudCode& code : kLaserBauds) {
    if (code.mode == baud_) put_word(115, code.status);
  }
  told[121] = configuration_[kUnitAt];
  std::copy(kVersion.begin(), kVersion.end(), told.begin() + 123);
  Bytes answer{0xb1};
  append(answer, told);
  reply(std::move(answer));
}

std::vector<double> LmsDevice::bearings_rad() const {
  const int count = 100 * field_deg_ / increment_cdeg_ + 1;
  std::vector<double> bearings;
  bearings.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    bearings.push_back(radians(-field_deg_ / 2.0 + i * increment_cdeg_ / 100.0));
  }
  return bearings;
}

void LmsDevice::step(TimePoint now, const std::vector<double>& ranges_m) {
  now_ = now;
  while (stream_.waiting() && now - heard_ > kLongestToLaser) {
    stream_.give_up_waiting();
    obey_all();
  }
  if (starting_) {
    starting_ = false;
    Bytes name = text_reply(0x90, kType);
    append(name, Bytes{kStatus});
    append(output_, lms200::encode({lms200::kFromLaser, std::move(name)}));
  }
  if (!measures(now) || ranges_m.empty()) return;
  asked_ = false;
  next_scan_ = now + kTurn;
  const bool millimetres = configuration_[kUnitAt] == 1;
  const auto unit = millimetres ? lms200::RangeUnit::millimetres : lms200::RangeUnit::centimetres;
  append(output_, lms200::encode(lms200::write_scan(ranges_m, unit)));
}

}  // namespace striate::pioneer
