#include "config/mistakes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "config/user_error.hpp"

namespace striate::config {
namespace {

std::string line_of(const std::string& source, int number) {
  std::istringstream stream(source);
  std::string line;
  for (int i = 0; i < number && std::getline(stream, line); ++i) {
  }
  if (!line.empty() && line.back() == '\r') line.pop_back();
  return stream.fail() ? std::string{} : line;
}

/// The caret's indentation: tabs stay tabs, so that the caret stands under its letter.
std::string blanks_before(const std::string& line, int column) {
  std::string blanks;
  for (int i = 0; i + 1 < column && i < static_cast<int>(line.size()); ++i) {
    const auto byte = static_cast<unsigned char>(line[static_cast<std::size_t>(i)]);
    if ((byte & 0xC0U) == 0x80U) continue;
    blanks += byte == '\t' ? '\t' : ' ';
  }
  return blanks;
}

}  // namespace

void Mistakes::add(Place place, std::string message, std::string hint) {
  list_.push_back({place, std::move(message), std::move(hint)});
}

std::string Mistakes::text() const {
  std::vector<Mistake> sorted = list_;
  std::stable_sort(sorted.begin(), sorted.end(), [](const Mistake& a, const Mistake& b) {
    return a.place.line != b.place.line ? a.place.line < b.place.line
                                        : a.place.column < b.place.column;
  });
  std::string text;
  for (const Mistake& mistake : sorted) {
    const Place& place = mistake.place;
    if (place.line == 0) {
      text += fmt::format("{}: error: {}\n", file_, mistake.message);
    } else {
      text +=
          fmt::format("{}:{}:{}: error: {}\n", file_, place.line, place.column, mistake.message);
      const std::string line = line_of(source_, place.line);
      if (!line.empty() && line.size() < 200) {
        text += fmt::format("    {}\n    {}^\n", line, blanks_before(line, place.column));
      }
    }
    if (!mistake.hint.empty()) text += fmt::format("    {}\n", mistake.hint);
  }
  return text;
}

void Mistakes::throw_if_any() const {
  if (none()) return;
  std::string message = text();
  message += fmt::format("{} mistake{} in {}", list_.size(), list_.size() == 1 ? "" : "s", file_);
  throw UserError(message);
}

}  // namespace striate::config
