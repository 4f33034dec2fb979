#pragma once

#include <algorithm>
#include <string_view>

namespace striate {

/// How what is added to the language of task scripts may be called: as keys of YAML and as
/// arguments of commands, lower_case_words.
[[nodiscard]] inline bool is_entry_name(std::string_view text) {
  const auto small = [](char c) { return c >= 'a' && c <= 'z'; };
  const auto fits = [small](char c) { return small(c) || (c >= '0' && c <= '9') || c == '_'; };
  return !text.empty() && small(text[0]) && std::all_of(text.begin(), text.end(), fits);
}

/// For the hint beside a name that is none.
inline constexpr const char* kEntryNameRule =
    "a name is a small letter, then small letters, digits and '_'";

}  // namespace striate
