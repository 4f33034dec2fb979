#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

/// Numbers and texts in bytes, little-endian: for files and for the wire.
namespace striate {

static_assert(std::endian::native == std::endian::little,
              "numbers are copied as they lie in memory");

using Bytes = std::vector<std::uint8_t>;
using ByteView = std::span<const std::uint8_t>;

inline void append(Bytes& to, ByteView bytes) {
  const std::size_t at = to.size();
  to.resize(at + bytes.size());
  std::copy(bytes.begin(), bytes.end(), to.begin() + static_cast<std::ptrdiff_t>(at));
}

/// Bytes do not hold what their form promises.
class BadBytes : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Takes values off the front of some bytes, which must outlive it.
class ByteReader {
 public:
  /// What reading beyond the end does. `zero`: everything reads as 0 and `ran_out` tells, for
  /// devices whose older firmware sends less. `throws`: BadBytes.
  enum class Beyond : std::uint8_t { zero, throws };

  explicit ByteReader(ByteView bytes, Beyond beyond = Beyond::throws)
      : bytes_(bytes), beyond_(beyond) {}

  /// A number as it lies in memory; a double bit for bit.
  template <class T>
  T take() {
    static_assert(std::is_arithmetic_v<T> && !std::is_same_v<T, bool>);
    T value{};
    const ByteView some = take_bytes(sizeof(T));
    if (!some.empty()) std::memcpy(&value, some.data(), sizeof(T));
    return value;
  }
  std::uint8_t u8() { return take<std::uint8_t>(); }
  std::uint16_t u16() { return take<std::uint16_t>(); }
  std::uint32_t u32() { return take<std::uint32_t>(); }
  std::int8_t i8() { return take<std::int8_t>(); }
  std::int16_t i16() { return take<std::int16_t>(); }
  std::int32_t i32() { return take<std::int32_t>(); }
  bool take_flag() { return take<std::uint8_t>() != 0; }

  /// Bytes or a text behind their 32-bit count.
  ByteView take_block() { return take_bytes(take<std::uint32_t>()); }
  std::string take_text() {
    const ByteView block = take_block();
    return {reinterpret_cast<const char*>(block.data()), block.size()};
  }
  /// A text up to the NUL, which is taken, too; without a NUL, all that is left.
  std::string take_c_string() {
    const auto end = std::find(bytes_.begin(), bytes_.end(), std::uint8_t{0});
    if (end == bytes_.end()) run_out();
    std::string text(bytes_.begin(), end);
    const auto taken = static_cast<std::size_t>(end - bytes_.begin());
    bytes_ = bytes_.subspan(std::min(bytes_.size(), taken + 1));
    return text;
  }
  /// A 32-bit count of things of at least `least_bytes` each. @throws BadBytes where more are
  /// promised than there is room for
  std::size_t take_count(std::size_t least_bytes) {
    const std::size_t count = take<std::uint32_t>();
    if (count * least_bytes > bytes_.size()) throw BadBytes("a list is longer than its bytes");
    return count;
  }
  /// @throws BadBytes where something is left
  void expect_end() const {
    if (!bytes_.empty()) throw BadBytes("there are bytes left over");
  }
  [[nodiscard]] std::size_t left() const { return bytes_.size(); }
  [[nodiscard]] bool ran_out() const { return ran_out_; }

 private:
  ByteView take_bytes(std::size_t count) {
    if (count > bytes_.size()) {
      run_out();
      bytes_ = {};
      return {};
    }
    const ByteView taken = bytes_.first(count);
    bytes_ = bytes_.subspan(count);
    return taken;
  }
  void run_out() {
    if (beyond_ == Beyond::throws) throw BadBytes("there are too few bytes");
    ran_out_ = true;
  }
  ByteView bytes_;
  Beyond beyond_;
  bool ran_out_ = false;
};

/// Appends values to bytes of its own, or to those that it is given.
class ByteWriter {
 public:
  ByteWriter() : bytes_(own_) {}
  explicit ByteWriter(Bytes& to) : bytes_(to) {}
  ByteWriter(const ByteWriter&) = delete;
  ByteWriter& operator=(const ByteWriter&) = delete;

  /// A number as it lies in memory; a double bit for bit.
  template <class T>
  void put(T value) {
    static_assert(std::is_arithmetic_v<T>);
    const std::size_t at = bytes_.size();
    bytes_.resize(at + sizeof(T));
    std::memcpy(bytes_.data() + at, &value, sizeof(T));
  }
  void u8(std::uint8_t value) { put(value); }
  void u16(std::uint16_t value) { put(value); }
  void u32(std::uint32_t value) { put(value); }
  void i8(std::int8_t value) { put(value); }
  void i16(std::int16_t value) { put(value); }
  void i32(std::int32_t value) { put(value); }

  /// Bytes or a text behind their 32-bit count.
  void put_block(ByteView block) {
    put(static_cast<std::uint32_t>(block.size()));
    append(bytes_, block);
  }
  void put_text(std::string_view text) {
    put_block({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
  }
  /// A text with a NUL behind it.
  void put_c_string(std::string_view text) {
    bytes_.insert(bytes_.end(), text.begin(), text.end());
    bytes_.push_back(0);
  }
  [[nodiscard]] const Bytes& bytes() const { return bytes_; }

 private:
  Bytes own_;
  Bytes& bytes_;
};

}  // namespace striate
