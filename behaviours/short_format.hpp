#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "behaviours/wish.hpp"

namespace striate {

/// A formatted reason, without allocation; what is too long is cut.
template <class... Args>
ShortText short_format(std::string_view format, const Args&... args) {
  std::array<char, ShortText::kCapacity> buffer;
  const auto end = fmt::format_to_n(buffer.data(), buffer.size(), fmt::runtime(format), args...);
  return std::string_view(buffer.data(), std::min<std::size_t>(end.size, buffer.size()));
}

}  // namespace striate
