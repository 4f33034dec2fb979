#pragma once

#include <cstdint>
#include <cstring>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace striate::replay {

/// What bytes do not keep what their form promises.
class BadBytes : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Appends values to bytes as they lie in memory: little-endian, doubles bit for bit.
class ByteWriter {
 public:
  explicit ByteWriter(std::vector<std::uint8_t>& bytes) : bytes_(bytes) {}
  template <class T>
  void put(T value) {
    static_assert(std::is_arithmetic_v<T>);
    const std::size_t at = bytes_.size();
    bytes_.resize(at + sizeof(T));
    std::memcpy(bytes_.data() + at, &value, sizeof(T));
  }
  void put_block(std::span<const std::uint8_t> block) {
    put(static_cast<std::uint32_t>(block.size()));
    bytes_.insert(bytes_.end(), block.begin(), block.end());
  }
  void put_text(std::string_view text) {
    put_block({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
  }

 private:
  std::vector<std::uint8_t>& bytes_;
};

/// Takes them out again. @throws BadBytes where there are too few.
class ByteReader {
 public:
  explicit ByteReader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}
  template <class T>
  T take() {
    static_assert(std::is_arithmetic_v<T> && !std::is_same_v<T, bool>);
    T value{};
    std::memcpy(&value, some(sizeof(T)).data(), sizeof(T));
    return value;
  }
  bool take_flag() { return take<std::uint8_t>() != 0; }
  std::span<const std::uint8_t> take_block() { return some(take<std::uint32_t>()); }
  std::string take_text() {
    const auto block = take_block();
    return {reinterpret_cast<const char*>(block.data()), block.size()};
  }
  /// A count of things of at least `least_bytes` each: never more than there is room for.
  std::size_t take_count(std::size_t least_bytes) {
    const std::size_t count = take<std::uint32_t>();
    if (count * least_bytes > bytes_.size()) throw BadBytes("a list is longer than its bytes");
    return count;
  }
  void expect_end() const {
    if (!bytes_.empty()) throw BadBytes("there are bytes left over");
  }

 private:
  std::span<const std::uint8_t> some(std::size_t count) {
    if (count > bytes_.size()) throw BadBytes("there are too few bytes");
    const auto taken = bytes_.first(count);
    bytes_ = bytes_.subspan(count);
    return taken;
  }
  std::span<const std::uint8_t> bytes_;
};

}  // namespace striate::replay
