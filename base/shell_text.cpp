#include "striate/base/shell_text.hpp"

#include <algorithm>

namespace striate {
namespace {

/// What no shell reads as anything but itself. A `~` at the front would be a home folder, and `=`
/// at a command's front an assignment; printed words stand behind the command.
bool means_itself(char c) {
  constexpr std::string_view kOthers = "%+,-./:=@_";
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
         kOthers.find(c) != std::string_view::npos;
}

}  // namespace

std::string shell_word(std::string_view text) {
  if (!text.empty() && std::all_of(text.begin(), text.end(), means_itself)) {
    return std::string(text);
  }
  std::string word = "'";
  for (const char c : text) {
    if (c == '\'') {
      word += "'\\''";
    } else {
      word += c;
    }
  }
  return word + "'";
}

}  // namespace striate
