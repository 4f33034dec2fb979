#include "striate/platform/pioneer/arcos/packet_stream.hpp"

namespace striate::pioneer::arcos {
namespace {

/// First byte of every packet; ARCOS manual, packet protocol
constexpr std::uint8_t kFirst = 0xfa;
/// Second byte of every packet; ARCOS manual, packet protocol
constexpr std::uint8_t kSecond = 0xfb;
constexpr std::size_t kLeastCount = 3;  ///< id and checksum

}  // namespace

void PacketStream::push(ByteView bytes) {
  if (at_ > 0) {
    buffer_.erase(buffer_.begin(), buffer_.begin() + static_cast<std::ptrdiff_t>(at_));
    at_ = 0;
  }
  append(buffer_, bytes);
}

void PacketStream::clear() {
  buffer_.clear();
  at_ = 0;
}

void PacketStream::drop(std::size_t count) {
  at_ += count;
  counters_.junk_bytes += count;
}

bool PacketStream::hunt() {
  while (at_ < buffer_.size()) {
    const bool first = buffer_[at_] == kFirst;
    if (first && at_ + 1 == buffer_.size()) return true;
    if (first && buffer_[at_ + 1] == kSecond) return true;
    drop(1);
  }
  return false;
}

std::optional<Packet> PacketStream::next() {
  while (hunt()) {
    const std::size_t left = buffer_.size() - at_;
    if (left < 3) return std::nullopt;
    const std::size_t count = buffer_[at_ + 2];
    if (count < kLeastCount) {
      ++counters_.bad_length;
      drop(1);
      continue;
    }
    if (left < count + 3) return std::nullopt;
    const ByteView body = ByteView(buffer_).subspan(at_ + 3, count - 2);
    const std::size_t sum_at = at_ + 1 + count;
    const auto told = static_cast<std::uint16_t>(buffer_[sum_at] << 8 | buffer_[sum_at + 1]);
    if (checksum(body) != told) {
      ++counters_.bad_checksum;
      drop(1);
      continue;
    }
    ++counters_.packets;
    at_ += count + 3;
    return Packet{body[0], Bytes(body.begin() + 1, body.end())};
  }
  return std::nullopt;
}

void PacketStream::give_up_waiting() {
  if (!waiting()) return;
  ++counters_.incomplete;
  drop(1);
}

}  // namespace striate::pioneer::arcos
