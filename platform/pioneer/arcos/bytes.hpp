#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace striate::pioneer {

using Bytes = std::vector<std::uint8_t>;
using ByteView = std::span<const std::uint8_t>;

inline void append(Bytes& to, ByteView bytes) {
  const std::size_t at = to.size();
  to.resize(at + bytes.size());
  std::copy(bytes.begin(), bytes.end(), to.begin() + static_cast<std::ptrdiff_t>(at));
}

/// Takes little-endian numbers off the front of some bytes. Beyond the end everything reads as 0
/// (older firmware simply sends less); `ran_out` tells.
class ByteReader {
 public:
  explicit ByteReader(ByteView bytes) : bytes_(bytes) {}

  std::uint8_t u8() { return static_cast<std::uint8_t>(take(1)); }
  std::uint16_t u16() { return static_cast<std::uint16_t>(take(2)); }
  std::uint32_t u32() { return take(4); }
  std::int8_t i8() { return static_cast<std::int8_t>(take(1)); }
  std::int16_t i16() { return static_cast<std::int16_t>(take(2)); }
  std::int32_t i32() { return static_cast<std::int32_t>(take(4)); }

  /// Up to the NUL, which is taken, too.
  std::string text() {
    const auto end = std::find(bytes_.begin(), bytes_.end(), std::uint8_t{0});
    std::string text(bytes_.begin(), end);
    ran_out_ = ran_out_ || end == bytes_.end();
    const auto taken = static_cast<std::size_t>(end - bytes_.begin());
    bytes_ = bytes_.subspan(std::min(bytes_.size(), taken + 1));
    return text;
  }
  [[nodiscard]] std::size_t left() const { return bytes_.size(); }
  [[nodiscard]] bool ran_out() const { return ran_out_; }

 private:
  std::uint32_t take(std::size_t size) {
    if (bytes_.size() < size) {
      ran_out_ = true;
      bytes_ = {};
      return 0;
    }
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < size; ++i) value |= std::uint32_t{bytes_[i]} << (8 * i);
    bytes_ = bytes_.subspan(size);
    return value;
  }
  ByteView bytes_;
  bool ran_out_ = false;
};

/// Appends little-endian numbers.
class ByteWriter {
 public:
  void u8(std::uint8_t value) { put(value, 1); }
  void u16(std::uint16_t value) { put(value, 2); }
  void u32(std::uint32_t value) { put(value, 4); }
  void i8(std::int8_t value) { put(static_cast<std::uint8_t>(value), 1); }
  void i16(std::int16_t value) { put(static_cast<std::uint16_t>(value), 2); }
  void i32(std::int32_t value) { put(static_cast<std::uint32_t>(value), 4); }
  void text(const std::string& value) {
    bytes_.insert(bytes_.end(), value.begin(), value.end());
    bytes_.push_back(0);
  }
  [[nodiscard]] const Bytes& bytes() const { return bytes_; }

 private:
  void put(std::uint32_t value, int size) {
    for (int i = 0; i < size; ++i) bytes_.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
  }
  Bytes bytes_;
};

}  // namespace striate::pioneer
