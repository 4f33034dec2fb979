#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "striate/base/bytes.hpp"

/// The ArbotiX board's command protocol: eight bytes FF | pan | tilt | buttons | ext | sum, words
/// high byte first. The turret's usual firmware; it tells no positions.
namespace striate::pioneer::arbotix {

/// The firmware's source sends pan first, its printed manual says tilt first.
enum class Order { pan_first, tilt_first };

struct HeadCommand {
  std::uint16_t pan_ticks = 512;  ///< 0 .. 1023
  std::uint16_t tilt_ticks = 512;
  std::uint8_t buttons = 0;
  std::uint8_t ext = 0;  ///< 0: just move
  friend bool operator==(const HeadCommand&, const HeadCommand&) = default;
};

inline constexpr std::size_t kSize = 8;  ///< bytes of a command; ArbotiX CommEXT
[[nodiscard]] Bytes encode(const HeadCommand& command, Order order = Order::pan_first);

/// Finds commands in a stream; any split gives the same ones.
class CommandStream {
 public:
  explicit CommandStream(Order order = Order::pan_first) : order_(order) {}
  void push(ByteView bytes) { append(buffer_, bytes); }
  [[nodiscard]] std::optional<HeadCommand> next();
  [[nodiscard]] std::uint64_t bad_sums() const { return bad_sums_; }

 private:
  Order order_;
  Bytes buffer_;
  std::uint64_t bad_sums_ = 0;
};

}  // namespace striate::pioneer::arbotix
