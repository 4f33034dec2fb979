#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "memory/short_term_memory.hpp"

namespace striate {

enum class Progress : std::uint8_t { running, succeeded, failed };

/// A short text without allocation; what is too long is cut.
class ShortText {
 public:
  static constexpr std::size_t kCapacity = 95;  ///< letters: 96 bytes with the end; more is cut
  ShortText() = default;
  ShortText(std::string_view text) {  // NOLINT(google-explicit-constructor): reads like a string
    size_ = std::min(text.size(), kCapacity);
    std::copy_n(text.data(), size_, text_.data());
  }
  ShortText(const char* text) : ShortText(std::string_view(text)) {}  // NOLINT
  [[nodiscard]] std::string_view view() const { return {text_.data(), size_}; }
  [[nodiscard]] bool empty() const { return size_ == 0; }

 private:
  std::array<char, kCapacity + 1> text_{};
  std::size_t size_ = 0;
};

/// What a behaviour wants in this cycle. A lease: it lapses 200 ms after `stamp`.
struct Wish {
  double forward_m_s = 0.0;
  double turn_rad_s = 0.0;
  double pan_rad = 0.0;
  double tilt_rad = 0.0;
  Progress progress = Progress::running;
  ShortText why;    ///< in words for a person: what it does, or why it stands or failed
  TimePoint stamp;  ///< when it was wished
};

/// Level, the camera sees the floor only from 4.1 m on; so tilted, from 2.2 m.
inline constexpr double kRestingTilt_rad = -0.227;

/// A wish of now: stand, look ahead and a little down.
[[nodiscard]] inline Wish standing_wish(const ShortTermMemory& memory, ShortText why) {
  Wish wish;
  wish.tilt_rad = kRestingTilt_rad;
  wish.why = why;
  wish.stamp = memory.now();
  return wish;
}

[[nodiscard]] inline Wish final_wish(const ShortTermMemory& memory, Progress progress,
                                     ShortText why) {
  Wish wish = standing_wish(memory, why);
  wish.progress = progress;
  return wish;
}

}  // namespace striate
