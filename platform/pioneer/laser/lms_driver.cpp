#include "striate/platform/pioneer/laser/lms_driver.hpp"

#include "striate/platform/interface/seen_from_axle.hpp"

namespace striate::pioneer {
namespace {

constexpr std::uint8_t kDone = 0xa0;  // reply to 20: operating mode; SICK LMS-200 telegrams
/// Reply to 3B: field and resolution; SICK LMS-200 telegrams
constexpr std::uint8_t kVariantSet = 0xbb;
constexpr std::uint8_t kConfigured = 0xf7;  // reply to 77: configuration; SICK LMS-200 telegrams
/// The mirror turns 75 times a second and sees half of each turn; a scan of 181 values takes 94 ms
/// at 38400 baud, and is as old when its last byte comes.
constexpr Duration kScanAge = std::chrono::milliseconds(100);
/// A scan of 401 values, 812 bytes, takes 211 ms at 38400 baud
constexpr Duration kLongestTelegram = std::chrono::milliseconds(500);

}  // namespace

void LmsDriver::close() {
  talk_.say(lms200::continuous(false), Step::closed, talk_.said_at());
}

void LmsDriver::receive(ByteView bytes, TimePoint now) {
  stream_.push(bytes);
  if (!incomplete_) incomplete_since_ = now;
  while (const auto telegram = stream_.next()) {
    take(*telegram, now);
    incomplete_since_ = now;
  }
  incomplete_ = stream_.waiting();
}

void LmsDriver::take(const lms200::Telegram& telegram, TimePoint now) {
  const Bytes& data = telegram.data;
  const std::uint8_t kind = data[0];
  const auto says = [&](std::uint8_t wanted, std::uint8_t result) {
    return kind == wanted && data.size() > 1 && data[1] == result;
  };
  switch (talk_.step()) {
    case Step::variant:
      if (says(kVariantSet, 1)) talk_.say(lms200::install_mode(), Step::install, now);
      return;
    case Step::install:
      if (says(kDone, 0)) talk_.say(lms200::set_millimetres(), Step::unit, now);
      return;
    case Step::unit:
      if (says(kConfigured, 1)) talk_.say(lms200::continuous(true), Step::start, now);
      return;
    case Step::start:
      if (says(kDone, 0)) talk_.expect_scans(now);
      return;
    case Step::scan:
      take_scan(telegram, now);
      return;
    case Step::begin:
    case Step::closed:
      return;
  }
}

void LmsDriver::take_scan(const lms200::Telegram& telegram, TimePoint now) {
  const auto scan = lms200::read_scan(telegram);
  if (!scan || scan->ranges_m.size() < 2) return;
  RangeScan& seen = talk_.begin_scan(now - kScanAge, now);
  const auto last = static_cast<double>(scan->ranges_m.size() - 1);
  for (std::size_t i = 0; i < scan->ranges_m.size(); ++i) {
    const double bearing_rad = radians(-90.0 + 180.0 * static_cast<double>(i) / last);
    seen.readings.push_back(
        seen_from_axle({talk_.settings().forward_m, 0.0, bearing_rad}, scan->ranges_m[i]));
  }
}

void LmsDriver::tick(TimePoint now) {
  if (incomplete_ && now - incomplete_since_ > kLongestTelegram) {
    stream_.give_up_waiting();
    incomplete_ = false;
    receive({}, now);
  }
  if (talk_.begins(now)) talk_.say(lms200::set_variant(180, 100), Step::variant, now);
}

}  // namespace striate::pioneer
