#pragma once

#include <cstdint>
#include <optional>

#include "striate/platform/pioneer/arcos/packet.hpp"

namespace striate::pioneer::arcos {

/// What went wrong on a line, by kind.
struct StreamCounters {
  std::uint64_t packets = 0;       ///< good ones
  std::uint64_t bad_checksum = 0;  ///< a header whose checksum does not fit
  std::uint64_t bad_length = 0;    ///< a count byte too small for any packet
  std::uint64_t incomplete = 0;    ///< given up waiting for its end
  std::uint64_t junk_bytes = 0;    ///< bytes outside packets
};

/// Cuts a stream of bytes into packets. Pure: no clock, no input or output. Any split of the same
/// bytes gives the same packets. After a bad checksum only the first FA is dropped and the rest is
/// read again, so one flipped bit costs one packet: what a wrong count byte has swallowed is found.
class PacketStream {
 public:
  void push(ByteView bytes);
  /// The next whole packet, if there is one.
  [[nodiscard]] std::optional<Packet> next();

  /// A packet has begun and its end is still to come.
  [[nodiscard]] bool waiting() const { return at_ < buffer_.size(); }
  /// Stops waiting for the end of the packet that has begun: a flipped count byte may promise more
  /// than ever comes. Call `next` again afterwards.
  void give_up_waiting();

  /// Forgets what has not been read yet; the counters stay.
  void clear();

  [[nodiscard]] const StreamCounters& counters() const { return counters_; }

 private:
  void drop(std::size_t count);
  /// Moves to the next FA FB (or an FA at the very end). False: none.
  bool hunt();

  Bytes buffer_;
  std::size_t at_ = 0;  ///< everything before has been dealt with
  StreamCounters counters_;
};

}  // namespace striate::pioneer::arcos
