#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>

namespace striate {

/// A text of at most `Capacity` bytes, without allocation; what is too long is cut.
template <std::size_t Capacity>
class FixedText {
 public:
  static constexpr std::size_t kCapacity = Capacity;
  FixedText() = default;
  FixedText(std::string_view text) {  // NOLINT(google-explicit-constructor): reads like a string
    size_ = std::min(text.size(), kCapacity);
    std::copy_n(text.data(), size_, text_.data());
  }
  FixedText(const char* text) : FixedText(std::string_view(text)) {}  // NOLINT

  [[nodiscard]] std::string_view view() const { return {text_.data(), size_}; }
  [[nodiscard]] const char* c_str() const { return text_.data(); }  ///< zero-terminated
  [[nodiscard]] bool empty() const { return size_ == 0; }
  void clear() { *this = FixedText(); }

  friend bool operator==(const FixedText& a, const FixedText& b) { return a.view() == b.view(); }

 private:
  std::array<char, kCapacity + 1> text_{};
  std::size_t size_ = 0;
};

}  // namespace striate
