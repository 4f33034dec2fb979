#pragma once

#include <string>

namespace striate::tasks {

/// Text as XML and SVG want it; control characters, which XML does not allow, become '?'.
[[nodiscard]] inline std::string escaped(const std::string& text) {
  std::string out;
  for (const char letter : text) {
    switch (letter) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += static_cast<unsigned char>(letter) < 0x20 ? '?' : letter;
    }
  }
  return out;
}

}  // namespace striate::tasks
