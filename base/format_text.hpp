#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "striate/base/fixed_text.hpp"

namespace striate {

/// A formatted FixedText, without allocation; what is too long is cut.
template <class Text, class... Args>
[[nodiscard]] Text format_text(fmt::format_string<Args...> format, Args&&... args) {
  std::array<char, Text::kCapacity> buffer;
  const auto end =
      fmt::format_to_n(buffer.data(), buffer.size(), format, std::forward<Args>(args)...);
  return std::string_view(buffer.data(), std::min<std::size_t>(end.size, buffer.size()));
}

}  // namespace striate
