#include "striate/platform/pioneer/firmware/lms_device.hpp"
#include "striate/platform/pioneer/laser/lms200.hpp"
#include "tests/fuzz/fuzz_target.hpp"

using namespace striate;
using namespace striate::pioneer;

namespace {

std::vector<lms200::Telegram> telegrams(ByteView bytes, std::size_t chunk) {
  lms200::TelegramStream stream;
  std::vector<lms200::Telegram> all;
  for (std::size_t at = 0; at < bytes.size(); at += chunk) {
    stream.push(bytes.subspan(at, std::min(chunk, bytes.size() - at)));
    while (auto telegram = stream.next()) all.push_back(std::move(*telegram));
  }
  while (stream.waiting()) {
    stream.give_up_waiting();
    while (auto telegram = stream.next()) all.push_back(std::move(*telegram));
  }
  return all;
}

std::string text_of(const Bytes& bytes) {
  return {bytes.begin(), bytes.end()};
}

void ask_a_device(ByteView bytes) {
  LmsDevice device;
  device.receive(bytes);
  const TimePoint now(std::chrono::seconds(1));
  device.step(now, std::vector<double>(device.bearings_rad().size(), 1.234));
  lms200::TelegramStream stream;
  stream.push(device.take_output());
  while (stream.next()) {
  }
  if (stream.counters().bad_crc != 0) __builtin_trap();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto all = telegrams({data, size}, 1);
  if (all != telegrams({data, size}, size + 1)) __builtin_trap();
  for (const auto& telegram : all) (void)lms200::read_scan(telegram);
  (void)lms200::read_scan({lms200::kFromLaser, Bytes(data, data + size)});
  ask_a_device({data, size});
  return 0;
}

std::vector<std::string> striate::fuzz::seeds() {
  const lms200::Telegram scan = lms200::write_scan(std::vector<double>(101, 2.0));
  return {text_of(lms200::reset()) + "\x06" + text_of(lms200::encode(scan)), text_of(scan.data),
          text_of(lms200::install_mode()) + text_of(lms200::set_millimetres()) +
              text_of(lms200::set_variant(100, 25)) + text_of(lms200::one_scan()) +
              text_of(lms200::encode({lms200::kToLaser, {0x31}}))};
}
