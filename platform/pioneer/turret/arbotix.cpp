#include "striate/platform/pioneer/turret/arbotix.hpp"

#include <utility>

namespace striate::pioneer::arbotix {
namespace {

constexpr std::uint8_t kStart = 0xff;  // first byte of a command; ArbotiX CommEXT

/// @param six the bytes between start and sum
std::uint8_t sum_of(ByteView six) {
  unsigned sum = 0;
  for (const std::uint8_t byte : six) sum += byte;
  return static_cast<std::uint8_t>(255U - sum % 256U);
}

}  // namespace

Bytes encode(const HeadCommand& command, Order order) {
  std::uint16_t first = command.pan_ticks & 0x3ffU;
  std::uint16_t second = command.tilt_ticks & 0x3ffU;
  if (order == Order::tilt_first) std::swap(first, second);
  Bytes bytes{kStart,
              static_cast<std::uint8_t>(first >> 8),
              static_cast<std::uint8_t>(first & 0xff),
              static_cast<std::uint8_t>(second >> 8),
              static_cast<std::uint8_t>(second & 0xff),
              command.buttons,
              command.ext};
  bytes.push_back(sum_of(ByteView(bytes).subspan(1)));
  return bytes;
}

std::optional<HeadCommand> CommandStream::next() {
  std::size_t at = 0;
  std::optional<HeadCommand> found;
  while (!found && buffer_.size() - at >= kSize) {
    const ByteView eight = ByteView(buffer_).subspan(at, kSize);
    // A position's high byte is at most 3: FF FF is no beginning.
    const bool begins = eight[0] == kStart && eight[1] <= 3 && eight[3] <= 3;
    if (!begins || sum_of(eight.subspan(1, 6)) != eight[7]) {
      bad_sums_ += begins ? 1 : 0;
      ++at;
      continue;
    }
    HeadCommand command;
    command.pan_ticks = static_cast<std::uint16_t>(eight[1] << 8 | eight[2]);
    command.tilt_ticks = static_cast<std::uint16_t>(eight[3] << 8 | eight[4]);
    if (order_ == Order::tilt_first) std::swap(command.pan_ticks, command.tilt_ticks);
    command.buttons = eight[5];
    command.ext = eight[6];
    found = command;
    at += kSize;
  }
  buffer_.erase(buffer_.begin(), buffer_.begin() + static_cast<std::ptrdiff_t>(at));
  return found;
}

}  // namespace striate::pioneer::arbotix
