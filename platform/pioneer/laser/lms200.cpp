#include "striate/platform/pioneer/laser/lms200.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace striate::pioneer::lms200 {
namespace {

constexpr std::uint8_t kStart = 0x02;     // STX, first byte of a telegram; SICK LMS-200 telegrams
constexpr std::uint8_t kTaken = 0x06;     // ACK before a reply; SICK LMS-200 telegrams
constexpr std::uint8_t kNotTaken = 0x15;  // NAK before a reply; SICK LMS-200 telegrams
constexpr std::uint8_t kScan = 0xb0;      // reply: measured values; SICK LMS-200 telegrams, B0
/// Low 13 bits of a value are the range; SICK LMS-200 telegrams, B0
constexpr unsigned kRangeBits = 0x1fffU;
/// Of 13 bits, the last nine are codes (dazzled, no echo); SICK LMS-200 telegrams
constexpr unsigned kFirstError = 0x1ff7U;

}  // namespace

std::uint16_t crc(ByteView bytes) {
  unsigned u = 0;
  unsigned newest = 0;
  for (const std::uint8_t byte : bytes) {
    const unsigned before = newest;
    newest = byte;
    u = (u & 0x8000U) != 0 ? ((u & 0x7fffU) << 1U) ^ 0x8005U : u << 1U;
    u ^= newest | before << 8U;
  }
  return static_cast<std::uint16_t>(u);
}

Bytes encode(const Telegram& telegram) {
  ByteWriter writer;
  writer.u8(kStart);
  writer.u8(telegram.address);
  writer.u16(static_cast<std::uint16_t>(telegram.data.size()));
  for (const std::uint8_t byte : telegram.data) writer.u8(byte);
  writer.u16(crc(writer.bytes()));
  return writer.bytes();
}

void TelegramStream::push(ByteView bytes) {
  buffer_.erase(buffer_.begin(), buffer_.begin() + static_cast<std::ptrdiff_t>(at_));
  at_ = 0;
  append(buffer_, bytes);
}

void TelegramStream::skip_byte() {
  switch (buffer_[at_++]) {
    case kTaken:
      ++counters_.acknowledged;
      return;
    case kNotTaken:
      ++counters_.refused;
      return;
    default:
      ++counters_.junk_bytes;
      return;
  }
}

void TelegramStream::give_up_waiting() {
  if (waiting()) skip_byte();
}

std::optional<Telegram> TelegramStream::next() {
  while (at_ < buffer_.size()) {
    const ByteView left = ByteView(buffer_).subspan(at_);
    if (left[0] != kStart) {
      skip_byte();
      continue;
    }
    if (left.size() >= 2 && (left[1] & kFromLaser) != sender_) {
      skip_byte();
      continue;
    }
    if (left.size() < 4) return std::nullopt;
    const std::size_t size = left[2] | static_cast<std::size_t>(left[3]) << 8U;
    if (size == 0 || size > kMostData) {
      ++counters_.bad_length;
      skip_byte();
      continue;
    }
    if (left.size() < size + 6) return std::nullopt;
    const unsigned told = left[size + 4] | static_cast<unsigned>(left[size + 5]) << 8U;
    if (crc(left.first(size + 4)) != told) {
      ++counters_.bad_crc;
      skip_byte();
      continue;
    }
    ++counters_.telegrams;
    const ByteView data = left.subspan(4, size);
    at_ += size + 6;
    return Telegram{left[1], Bytes(data.begin(), data.end())};
  }
  return std::nullopt;
}

Bytes reset() {
  return encode({kToLaser, {0x10}});
}

Bytes install_mode() {
  return encode({kToLaser, {0x20, 0x00, 'S', 'I', 'C', 'K', '_', 'L', 'M', 'S'}});
}

Bytes set_millimetres() {
  Bytes data(33, 0);
  data[0] = 0x77;
  // Where it stands in the configuration; SICK LMS-200 telegrams, 77
  constexpr std::size_t kStopThreshold = 3;
  // Where it stands in the configuration, 1: mm; SICK LMS-200 telegrams, 77
  constexpr std::size_t kUnit = 7;
  data[kStopThreshold] = 0x46;  // the factory's
  data[6] = 5;                  // the factory's field of measured values: plain ranges
  data[kUnit] = 1;
  data[10] = 2;
  data[11] = 2;
  return encode({kToLaser, data});
}

Bytes continuous(bool on) {
  return encode({kToLaser, {0x20, static_cast<std::uint8_t>(on ? 0x24 : 0x25)}});
}

Bytes one_scan() {
  return encode({kToLaser, {0x30, 0x01}});
}

Bytes set_variant(int fov_deg, int increment_cdeg) {
  ByteWriter writer;
  writer.u8(0x3b);
  writer.u16(static_cast<std::uint16_t>(fov_deg));
  writer.u16(static_cast<std::uint16_t>(increment_cdeg));
  return encode({kToLaser, writer.bytes()});
}

std::optional<Scan> read_scan(const Telegram& telegram) {
  if (telegram.data.empty() || telegram.data[0] != kScan) return std::nullopt;
  ByteReader reader(ByteView(telegram.data).subspan(1), ByteReader::Beyond::zero);
  const unsigned head = reader.u16();
  const std::size_t count = head & 0x3ffU;
  const unsigned unit = head >> 14U;
  if (reader.left() < 2 * count || unit > 2) return std::nullopt;
  // By bits 14 and 15 of the count: cm, mm, dm; SICK LMS-200 telegrams, B0
  constexpr double kUnits_m[] = {0.01, 0.001, 0.1};
  Scan scan;
  scan.ranges_m.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const unsigned value = reader.u16() & kRangeBits;
    scan.ranges_m.push_back(value >= kFirstError ? std::numeric_limits<double>::infinity()
                                                 : value * kUnits_m[unit]);
  }
  scan.status = reader.u8();
  return scan;
}

Telegram write_scan(const std::vector<double>& ranges_m, RangeUnit unit) {
  const bool millimetres = unit == RangeUnit::millimetres;
  const double units_a_metre = millimetres ? 1000.0 : 100.0;
  ByteWriter writer;
  writer.u8(kScan);
  writer.u16(static_cast<std::uint16_t>((ranges_m.size() & 0x3ffU) | (millimetres ? 0x4000U : 0U)));
  for (const double range_m : ranges_m) {
    const double units = std::isfinite(range_m) ? units_a_metre * range_m : kRangeBits;
    writer.u16(static_cast<std::uint16_t>(std::lround(std::clamp(units, 0.0, double{kRangeBits}))));
  }
  writer.u8(0x10);  // as a laser in order says it
  return {kFromLaser, writer.bytes()};
}

}  // namespace striate::pioneer::lms200
