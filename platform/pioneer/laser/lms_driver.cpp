#include "striate/platform/pioneer/laser/lms_driver.hpp"

#include "striate/platform/interface/seen_from_axle.hpp"

namespace striate::pioneer {
namespace {

constexpr std::uint8_t kDone = 0xa0;  // reply to 20: operating mode; SICK LMS-200 telegrams
/// Reply to 3B: field and resolution; SICK LMS-200 telegrams
constexpr std::uint8_t kVariantSet = 0xbb;
constexpr std::uint8_t kConfigured = 0xf7;  // reply to 77: configuration; SICK LMS-200 telegrams
/// The mirror turns 75 times a second: what is sent at once was measured up to two turns before
constexpr Duration kScanAge = std::chrono::milliseconds(27);
/// A scan of 181 values takes 97 ms at 38400 baud
constexpr Duration kAskScan = std::chrono::milliseconds(100);
constexpr std::uint8_t kScanTold = 0xb0;  // reply to 30: a scan; SICK LMS-200 telegrams
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
  const auto asked_at = questions_.answer(kind);
  switch (talk_.step()) {
    case Step::variant:
      if (says(kVariantSet, 1)) ask(lms200::install_mode(), Step::install, now);
      return;
    case Step::install:
      if (says(kDone, 0)) ask(lms200::set_millimetres(), Step::unit, now);
      return;
    case Step::unit:
      if (says(kConfigured, 1)) ask(lms200::continuous(false), Step::start, now);
      return;
    case Step::start:
      if (!says(kDone, 0)) return;
      talk_.expect_scans(now);
      ask(lms200::one_scan(), Step::scan, now);
      return;
    case Step::scan:
      if (asked_at) take_scan(telegram, *asked_at, now);  // else it may be of any age
      return;
    case Step::begin:
    case Step::closed:
      return;
  }
}

void LmsDriver::take_scan(const lms200::Telegram& telegram, TimePoint asked_at, TimePoint now) {
  const auto scan = lms200::read_scan(telegram);
  if (!scan || scan->ranges_m.size() < 2) return;
  waiting_ = false;
  RangeScan& seen = talk_.begin_scan(asked_at - kScanAge, now);
  const auto last = static_cast<double>(scan->ranges_m.size() - 1);
  for (std::size_t i = 0; i < scan->ranges_m.size(); ++i) {
    const double bearing_rad = radians(-90.0 + 180.0 * static_cast<double>(i) / last);
    seen.readings.push_back(
        seen_from_axle({talk_.settings().forward_m, 0.0, bearing_rad}, scan->ranges_m[i]));
  }
}

void LmsDriver::ask(ByteView bytes, Step step, TimePoint now) {
  talk_.say(bytes, step, now);
  switch (step) {
    case Step::variant:
      questions_.ask(kVariantSet, now);
      return;
    case Step::unit:
      questions_.ask(kConfigured, now);
      return;
    case Step::scan:
      questions_.ask(kScanTold, now);
      waiting_ = true;
      return;
    default:
      questions_.ask(kDone, now);
  }
}

void LmsDriver::tick(TimePoint now) {
  if (incomplete_ && now - incomplete_since_ > kLongestTelegram) {
    stream_.give_up_waiting();
    incomplete_ = false;
    receive({}, now);
  }
  if (const std::uint64_t bad = stream_.counters().bad_crc; bad != bad_seen_) {
    bad_seen_ = bad;
    waiting_ = false;  // what came was spoiled on the way
  }
  const Duration patience = from_seconds(talk_.settings().reply_patience_s);
  if (talk_.begins(now)) {
    ask(lms200::set_variant(180, 100), Step::variant, now);
  } else if (talk_.step() == Step::scan &&
             now - talk_.said_at() >= (waiting_ ? patience : kAskScan)) {
    ask(lms200::one_scan(), Step::scan, now);
  }
}

}  // namespace striate::pioneer
