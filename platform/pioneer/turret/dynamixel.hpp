#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "striate/base/bytes.hpp"

/// Dynamixel protocol 1.0, as AX-12A servos speak it: FF FF | id | length | instruction or error |
/// parameters | sum. A byte is either way the complement of the sum from id to the last parameter.
namespace striate::pioneer::dynamixel {

enum class Instruction : std::uint8_t {
  ping = 1,
  read = 2,
  write = 3,
  register_write = 4,
  action = 5,
  reset = 6,
  sync_write = 0x83,
};

/// AX-12A control table, speed and load: bit 10 is clockwise, below it ten bits of size.
constexpr std::uint16_t kClockwise = 1U << 10;
constexpr std::uint16_t kSizeBits = kClockwise - 1U;

/// Registers of the AX-12A; two bytes where it says word.
struct Register {
  static constexpr std::uint8_t model = 0;  // word
  static constexpr std::uint8_t firmware = 2;
  static constexpr std::uint8_t id = 3;
  static constexpr std::uint8_t baud = 4;
  static constexpr std::uint8_t return_delay = 5;  // 2 us
  static constexpr std::uint8_t cw_limit = 6;      // word
  static constexpr std::uint8_t ccw_limit = 8;     // word
  static constexpr std::uint8_t most_temperature = 11;
  static constexpr std::uint8_t least_voltage = 12;
  static constexpr std::uint8_t most_voltage = 13;
  static constexpr std::uint8_t most_torque = 14;   // word
  static constexpr std::uint8_t status_level = 16;  // 0: replies to PING, 1: and READ, 2: to all
  static constexpr std::uint8_t alarm_led = 17;
  static constexpr std::uint8_t alarm_shutdown = 18;
  static constexpr std::uint8_t torque_enable = 24;
  static constexpr std::uint8_t led = 25;
  static constexpr std::uint8_t cw_margin = 26;
  static constexpr std::uint8_t ccw_margin = 27;
  static constexpr std::uint8_t cw_slope = 28;
  static constexpr std::uint8_t ccw_slope = 29;
  static constexpr std::uint8_t goal_position = 30;  // word
  static constexpr std::uint8_t moving_speed = 32;   // word; 0 is the fastest
  static constexpr std::uint8_t torque_limit = 34;   // word
  static constexpr std::uint8_t position = 36;       // word
  static constexpr std::uint8_t speed = 38;          // word
  static constexpr std::uint8_t load = 40;           // word
  static constexpr std::uint8_t voltage = 42;        // 0.1 V
  static constexpr std::uint8_t temperature = 43;    // deg C
  static constexpr std::uint8_t registered = 44;
  static constexpr std::uint8_t moving = 46;
  static constexpr std::uint8_t lock = 47;
  static constexpr std::uint8_t punch = 48;  // word
};

/// Bits of a reply's error byte.
struct Error {
  static constexpr std::uint8_t voltage = 1U << 0;
  static constexpr std::uint8_t angle_limit = 1U << 1;
  static constexpr std::uint8_t overheat = 1U << 2;
  static constexpr std::uint8_t range = 1U << 3;
  static constexpr std::uint8_t checksum = 1U << 4;
  static constexpr std::uint8_t overload = 1U << 5;
  static constexpr std::uint8_t instruction = 1U << 6;
};

/// Id of all servos, none of which answers; Dynamixel protocol 1.0
inline constexpr std::uint8_t kBroadcast = 0xfe;

struct Packet {
  std::uint8_t id = 0;
  std::uint8_t code = 0;  ///< instruction to a servo, error bits from it
  Bytes parameters;       ///< at most 250
  friend bool operator==(const Packet&, const Packet&) = default;
};
[[nodiscard]] Bytes encode(const Packet& packet);

struct Counters {
  std::uint64_t packets = 0;
  std::uint64_t bad_sum = 0;
  std::uint64_t bad_length = 0;
  std::uint64_t junk_bytes = 0;
};

/// Cuts a stream into packets; any split gives the same ones, one wrong bit costs one packet.
class PacketStream {
 public:
  void push(ByteView bytes);
  [[nodiscard]] std::optional<Packet> next();
  [[nodiscard]] bool waiting() const { return at_ < buffer_.size(); }
  void give_up_waiting();
  /// Ids of the packets that were dropped since the last call because their sum is wrong; true ones
  /// as far as the wrong byte is another.
  [[nodiscard]] Bytes take_bad_sums() { return std::exchange(bad_sums_, {}); }
  [[nodiscard]] const Counters& counters() const { return counters_; }

 private:
  void skip_byte();
  Bytes buffer_;
  std::size_t at_ = 0;
  Bytes bad_sums_;
  Counters counters_;
};

[[nodiscard]] Bytes ping(std::uint8_t id);
[[nodiscard]] Bytes read(std::uint8_t id, std::uint8_t address, std::uint8_t count);
[[nodiscard]] Bytes write_byte(std::uint8_t id, std::uint8_t address, std::uint8_t value);
[[nodiscard]] Bytes write_word(std::uint8_t id, std::uint8_t address, std::uint16_t value);

struct Goal {
  std::uint8_t id = 0;
  double angle_rad = 0.0;
  double speed_rad_s = 0.5;
};
/// Goal and speed of several servos in one packet, to which no servo replies.
[[nodiscard]] Bytes move(const std::vector<Goal>& goals);

/// 0 .. 1023 is 300 degrees, 512 straight ahead, up is counter-clockwise. Clamped to the ends.
[[nodiscard]] std::uint16_t ticks_of(double angle_rad);
[[nodiscard]] double angle_of(std::uint16_t ticks);
/// In 0.111 rpm, never 0: that would be the fastest.
[[nodiscard]] std::uint16_t speed_ticks_of(double speed_rad_s);

}  // namespace striate::pioneer::dynamixel
