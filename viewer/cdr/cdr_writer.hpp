#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "striate/base/bytes.hpp"

namespace striate::viewer {

/// A message of ROS 2, ours or another's: names its type and hands its fields on, in their order.
template <class T>
concept RosMessage = requires {
  { T::kType } -> std::convertible_to<const char*>;
};

/// Writes messages as ROS 2 does on the wire and in files: CDR 1, little-endian. Four bytes of
/// encapsulation header; each number is aligned to its own size, counted after that header.
class CdrWriter {
 public:
  /// @param to is emptied first; its room is used again.
  explicit CdrWriter(Bytes& to) : bytes_(to) {
    bytes_.clear();
    append(bytes_, kHeader);
  }

  /// A field. The name is what the schema calls it, and is not written.
  template <class T>
  void operator()(const char* /*name*/, const T& value) {
    put(value);
  }
  template <class T>
  void put(const T& value) {
    if constexpr (std::is_same_v<T, bool>) {
      put_number(static_cast<std::uint8_t>(value));
    } else if constexpr (std::is_same_v<T, std::byte>) {
      put_number(static_cast<std::uint8_t>(value));
    } else if constexpr (std::is_arithmetic_v<T>) {
      put_number(value);
    } else {
      value.each_field(*this);
    }
  }
  /// The length counts the NUL.
  void put(const std::string& text) {
    put_number(static_cast<std::uint32_t>(text.size() + 1));
    ByteWriter(bytes_).put_c_string(text);
  }
  template <class T>
  void put(const std::vector<T>& list) {
    put_number(static_cast<std::uint32_t>(list.size()));
    put_all(list.data(), list.size());
  }
  template <class T, std::size_t kSize>
  void put(const std::array<T, kSize>& list) {
    put_all(list.data(), kSize);
  }

 private:
  /// CDR, little-endian, no options.
  static constexpr std::array<std::uint8_t, 4> kHeader{0, 1, 0, 0};

  template <class T>
  void put_number(T value) {
    align(sizeof(T));
    ByteWriter(bytes_).put(value);
  }
  /// An empty list adds no padding.
  template <class T>
  void put_all(const T* from, std::size_t count) {
    if constexpr (std::is_arithmetic_v<T> && !std::is_same_v<T, bool>) {
      if (count == 0) return;
      align(sizeof(T));
      append(bytes_, {reinterpret_cast<const std::uint8_t*>(from), count * sizeof(T)});
    } else {
      for (std::size_t k = 0; k < count; ++k) put(from[k]);
    }
  }
  void align(std::size_t to) {
    const std::size_t behind_header = bytes_.size() - kHeader.size();
    bytes_.resize(bytes_.size() + (to - behind_header % to) % to);
  }

  Bytes& bytes_;
};

/// @param to gets the message's bytes, and nothing else
template <RosMessage Message>
void encode_cdr(const Message& message, Bytes& to) {
  CdrWriter writer(to);
  message.each_field(writer);
}

}  // namespace striate::viewer
