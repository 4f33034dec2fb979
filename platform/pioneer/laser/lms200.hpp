#pragma once

#include <optional>
#include <vector>

#include "striate/base/bytes.hpp"

/// The SICK LMS-200's telegrams: 02 | address | length | data | CRC, little-endian; before a reply
/// one byte says 06 (taken) or 15 (not taken).
namespace striate::pioneer::lms200 {

inline constexpr std::uint8_t kToLaser = 0x00;  ///< address of the laser; SICK LMS-200 telegrams
/// Address of what comes from it; SICK LMS-200 telegrams
inline constexpr std::uint8_t kFromLaser = 0x80;
inline constexpr std::size_t kMostData = 1200;  ///< a scan of 401 values is 806

[[nodiscard]] std::uint16_t crc(ByteView bytes);

struct Telegram {
  std::uint8_t address = kToLaser;
  Bytes data;  ///< first byte: command or reply
  friend bool operator==(const Telegram&, const Telegram&) = default;
};
[[nodiscard]] Bytes encode(const Telegram& telegram);

struct Counters {
  std::uint64_t telegrams = 0;
  std::uint64_t bad_crc = 0;
  std::uint64_t bad_length = 0;
  std::uint64_t acknowledged = 0;
  std::uint64_t refused = 0;
  std::uint64_t junk_bytes = 0;
};

/// Cuts a stream into telegrams; any split gives the same ones. After a bad CRC only the first 02
/// is dropped. Only telegrams of the side that is listened to count: runs of zeros inside a
/// telegram would otherwise pass for another one, because the CRC of zeros is zero.
class TelegramStream {
 public:
  /// @param sender kFromLaser at the program's end, kToLaser at the laser's
  explicit TelegramStream(std::uint8_t sender = kFromLaser) : sender_(sender) {}
  void push(ByteView bytes);
  [[nodiscard]] std::optional<Telegram> next();
  [[nodiscard]] bool waiting() const { return at_ < buffer_.size(); }
  /// Stops waiting for the end of the telegram that has begun.
  void give_up_waiting();
  [[nodiscard]] const Counters& counters() const { return counters_; }

 private:
  void skip_byte();
  std::uint8_t sender_;
  Bytes buffer_;
  std::size_t at_ = 0;
  Counters counters_;
};

[[nodiscard]] Bytes reset();
/// Settings may be changed after this.
[[nodiscard]] Bytes install_mode();
/// Millimetres instead of centimetres.
[[nodiscard]] Bytes set_millimetres();
/// 20 "mode": 24 continuous, 25 on request.
[[nodiscard]] Bytes continuous(bool on);
/// Asks for one scan, of a laser that measures on request.
[[nodiscard]] Bytes one_scan();
/// @param fov_deg 100 or 180; @param increment_cdeg 100, 50 or 25; 0 keeps the old one
[[nodiscard]] Bytes set_variant(int fov_deg, int increment_cdeg);

struct Scan {
  std::vector<double> ranges_m;  ///< from right to left, evenly over the field of view
  std::uint8_t status = 0;
};
/// Empty when the telegram is no B0 or shorter than it says. Values from 1FF7 on are errors of the
/// device and read as +inf.
[[nodiscard]] std::optional<Scan> read_scan(const Telegram& telegram);
/// What a value of a scan counts, as bits 14 and 15 of its head say it.
enum class RangeUnit : std::uint8_t { centimetres = 0, millimetres = 1 };
/// As a laser sends it.
[[nodiscard]] Telegram write_scan(const std::vector<double>& ranges_m,
                                  RangeUnit unit = RangeUnit::millimetres);

}  // namespace striate::pioneer::lms200
