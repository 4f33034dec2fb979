#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "striate/platform/pioneer/arcos/packet.hpp"

namespace striate::pioneer {

/// Cuts a stream of ARCOS bytes into whole packets and bytes that belong to none, as
/// arcos::PacketStream does, but allocates nothing: it works in the keeper's process, see
/// kept_line.hpp.
class PacketCutter {
 public:
  /// Calls take(bytes, is_a_packet) for all that is whole, in the order of the stream; the
  /// beginning of a packet is held until its end comes.
  template <class Take>
  void push(ByteView bytes, Take&& take) {
    for (const std::uint8_t byte : bytes) {
      held_[size_++] = byte;
      while (const std::size_t whole = whole_bytes()) {
        take(ByteView(held_.data(), whole), whole > 1);
        drop(whole);
      }
    }
  }

 private:
  /// How much at the front is whole: a packet, or one byte of none. 0: its end is still to come.
  [[nodiscard]] std::size_t whole_bytes() const {
    constexpr std::uint8_t kFirst = 0xfa;   // ARCOS manual, packet protocol
    constexpr std::uint8_t kSecond = 0xfb;  // ARCOS manual, packet protocol
    /// Bytes: id and checksum; ARCOS manual, packet protocol
    constexpr std::size_t kLeastCount = 3;
    if (size_ == 0) return 0;
    if (held_[0] != kFirst || (size_ > 1 && held_[1] != kSecond)) return 1;
    if (size_ < 3) return 0;
    const std::size_t count = held_[2];
    if (count < kLeastCount) return 1;
    if (size_ < count + 3) return 0;
    const auto told = static_cast<std::uint16_t>(held_[count + 1] << 8 | held_[count + 2]);
    return arcos::checksum(ByteView(held_.data() + 3, count - 2)) == told ? count + 3 : 1;
  }
  void drop(std::size_t count) {
    std::copy(held_.begin() + static_cast<std::ptrdiff_t>(count),
              held_.begin() + static_cast<std::ptrdiff_t>(size_), held_.begin());
    size_ -= count;
  }

  std::array<std::uint8_t, 260> held_{};  ///< the longest packet has 258 bytes
  std::size_t size_ = 0;
};

}  // namespace striate::pioneer
