#include "striate/base/plain_text.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdint>

namespace striate {
namespace {

struct Letter {
  std::uint32_t code = 0;
  std::size_t bytes = 1;
  bool good = false;  ///< well-formed UTF-8
};

/// The forms of UTF-8 with two, three and four bytes (RFC 3629): how the first byte begins, and the
/// least code that may be written so.
struct Form {
  unsigned mask;
  unsigned begins;
  std::uint32_t least;
};
constexpr std::array<Form, 3> kForms = {
    {{0xE0U, 0xC0U, 0x80U}, {0xF0U, 0xE0U, 0x800U}, {0xF8U, 0xF0U, 0x10000U}}};

Letter letter_at(std::string_view text, std::size_t at) {
  const auto first = static_cast<unsigned char>(text[at]);
  if (first < 0x80U) return {first, 1, true};
  for (std::size_t more = 1; more <= kForms.size(); ++more) {
    const Form& form = kForms[more - 1];
    if ((first & form.mask) != form.begins || at + more >= text.size()) continue;
    std::uint32_t code = first & ~form.mask & 0xFFU;
    for (std::size_t k = 1; k <= more; ++k) {
      const auto next = static_cast<unsigned char>(text[at + k]);
      if ((next & 0xC0U) != 0x80U) return {first, 1, false};
      code = (code << 6U) | (next & 0x3FU);
    }
    const bool surrogate = code >= 0xD800U && code <= 0xDFFFU;
    const bool good = code >= form.least && code <= 0x10FFFFU && !surrogate;
    return {good ? code : first, good ? more + 1 : 1, good};
  }
  return {first, 1, false};
}

struct Codes {
  std::uint32_t first;
  std::uint32_t last;
};
/// Unicode 15: controls (Cc), line and paragraph separators, the marks and isolates of the
/// bidirectional algorithm (UAX 9), the byte order mark, and the two that are no characters.
constexpr std::array<Codes, 9> kNotShown = {{{0x00, 0x1F},
                                             {0x7F, 0x9F},
                                             {0x061C, 0x061C},
                                             {0x200E, 0x200F},
                                             {0x2028, 0x202E},
                                             {0x2066, 0x2069},
                                             {0xFEFF, 0xFEFF},
                                             {0xFFF9, 0xFFFB},
                                             {0xFFFE, 0xFFFF}}};

bool is_shown(const Letter& letter) {
  if (!letter.good) return false;
  for (const Codes& codes : kNotShown) {
    if (letter.code >= codes.first && letter.code <= codes.last) return false;
  }
  return true;
}

}  // namespace

bool is_plain_text(std::string_view text) {
  for (std::size_t at = 0; at < text.size();) {
    const Letter letter = letter_at(text, at);
    if (!is_shown(letter)) return false;
    at += letter.bytes;
  }
  return true;
}

std::string plain_text(std::string_view text) {
  std::string plain;
  plain.reserve(text.size());
  for (std::size_t at = 0; at < text.size();) {
    const Letter letter = letter_at(text, at);
    if (is_shown(letter)) {
      plain += text.substr(at, letter.bytes);
    } else {
      plain += letter.good ? fmt::format("\\u{:04X}", letter.code)
                           : fmt::format("\\x{:02X}", letter.code);
    }
    at += letter.bytes;
  }
  return plain;
}

std::string plain_lines(std::string_view text) {
  std::string plain;
  for (;;) {
    const std::size_t end = text.find_first_of("\n\t");
    plain += plain_text(text.substr(0, end));
    if (end == std::string_view::npos) return plain;
    plain += text[end];
    text.remove_prefix(end + 1);
  }
}

std::string xml_text(std::string_view text) {
  std::string out;
  for (const char letter : plain_text(text)) {
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
        out += letter;
    }
  }
  return out;
}

std::string csv_cell(std::string_view text) {
  const std::string plain = plain_text(text);
  if (plain.find_first_of(",\"") == std::string::npos) return plain;
  std::string cell = "\"";
  for (const char letter : plain) {
    if (letter == '"') cell += '"';
    cell += letter;
  }
  return cell + "\"";
}

}  // namespace striate
