#include "striate/platform/pioneer/firmware/lms_device.hpp"

namespace striate::pioneer {
namespace {

constexpr std::uint8_t kTaken = 0x06;     ///< byte before a reply; SICK LMS-200 telegrams
constexpr std::uint8_t kNotTaken = 0x15;  ///< byte before a reply; SICK LMS-200 telegrams
constexpr std::uint8_t kStatus = 0x10;    ///< the laser is in order
/// Between scans: 371 bytes of one take 97 ms at 38400 baud
constexpr Duration kTurn = std::chrono::milliseconds(100);

}  // namespace

Bytes LmsDevice::take_output() {
  Bytes bytes;
  bytes.swap(output_);
  return bytes;
}

void LmsDevice::receive(ByteView bytes) {
  stream_.push(bytes);
  while (const auto telegram = stream_.next()) obey(*telegram);
}

void LmsDevice::reply(Bytes data) {
  data.push_back(kStatus);
  append(output_, Bytes{kTaken});
  append(output_, lms200::encode({lms200::kFromLaser, std::move(data)}));
}

void LmsDevice::obey(const lms200::Telegram& telegram) {
  const Bytes& data = telegram.data;
  const std::uint8_t mode = data.size() > 1 ? data[1] : 0xff;
  switch (data[0]) {
    case 0x10:
      scanning_ = false;
      reply({0x91});
      return;
    case 0x20:
      installing_ = mode == 0x00;
      scanning_ = mode == 0x24;
      reply({0xa0, 0x00});
      return;
    case 0x30:
      if (mode != 0x01) break;
      asked_ = true;
      output_.push_back(kTaken);
      return;
    case 0x3b:
      if (data.size() != 5) break;
      reply({0xbb, 0x01, data[1], data[2], data[3], data[4]});
      return;
    case 0x77: {
      Bytes answer{0xf7, static_cast<std::uint8_t>(installing_ ? 0x01 : 0x00)};
      append(answer, ByteView(data).subspan(1));
      reply(std::move(answer));
      return;
    }
    default:
      break;
  }
  output_.push_back(kNotTaken);
}

void LmsDevice::step(TimePoint now, const std::vector<double>& ranges_m) {
  if (!asked_ && (!scanning_ || now < next_scan_)) return;
  asked_ = false;
  next_scan_ = now + kTurn;
  append(output_, lms200::encode(lms200::write_scan(ranges_m)));
}

}  // namespace striate::pioneer
