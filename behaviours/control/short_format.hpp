#pragma once

#include <string_view>

#include "striate/base/format_text.hpp"
#include "striate/behaviours/control/wish.hpp"

namespace striate::behaviours {

/// A formatted reason, without allocation; what is too long is cut.
template <class... Args>
ShortText short_format(std::string_view format, const Args&... args) {
  return format_text<ShortText, const Args&...>(fmt::runtime(format), args...);
}

}  // namespace striate::behaviours
