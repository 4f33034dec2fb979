#include "striate/config/diagnostics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "striate/base/plain_text.hpp"
#include "striate/base/user_error.hpp"

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

void Diagnostics::add(Fault fault, SourceLocation place, std::string message, std::string hint) {
  list_.push_back({place, std::move(message), std::move(hint), fault});
}

void Diagnostics::include(const Diagnostics& of_used_file) {
  if (of_used_file.none()) return;
  std::string text = of_used_file.text();
  if (std::find(included_.begin(), included_.end(), text) != included_.end()) return;
  included_.push_back(std::move(text));
  included_count_ += of_used_file.count();
}

std::vector<Diagnostic> Diagnostics::take_at(SourceLocation place) {
  std::vector<Diagnostic> taken;
  std::erase_if(list_, [&](const Diagnostic& diagnostic) {
    if (diagnostic.place != place) return false;
    taken.push_back(diagnostic);
    return true;
  });
  return taken;
}

/// SourceLocation, kind and message; the line itself with a caret; the hint.
std::string Diagnostics::told(const Diagnostic& diagnostic, const std::string& kind) const {
  const SourceLocation& place = diagnostic.place;
  std::string text = file_;
  if (place.line > 0) text += fmt::format(":{}:{}", place.line, place.column);
  text += fmt::format(": {}: {}\n", kind, diagnostic.message);
  const std::string line = place.line > 0 ? line_of(source_, place.line) : std::string();
  if (!line.empty() && line.size() < 200) {
    text += fmt::format("    {}\n    {}^\n", plain_lines(line), blanks_before(line, place.column));
  }
  if (!diagnostic.hint.empty()) text += fmt::format("    {}\n", diagnostic.hint);
  return text;
}

std::string Diagnostics::text_of(const Diagnostic& diagnostic) const {
  std::string text = told(
      diagnostic,
      letter_ == 0 ? "error" : fmt::format("error[{}{:03}]", letter_, diagnostic.fault.number));
  for (const Note& note : notes_) {
    if (note.place == diagnostic.place) text += fmt::format("    {}\n", note.text);
  }
  return text;
}

std::string Diagnostics::text() const {
  std::vector<Diagnostic> sorted = list_;
  std::stable_sort(sorted.begin(), sorted.end(), [](const Diagnostic& a, const Diagnostic& b) {
    return a.place.line != b.place.line ? a.place.line < b.place.line
                                        : a.place.column < b.place.column;
  });
  std::string text;
  for (const Diagnostic& diagnostic : sorted) text += text_of(diagnostic);
  for (const std::string& of_used_file : included_) text += of_used_file;
  return text;
}

std::string Diagnostics::warnings() const {
  std::string text;
  for (const Diagnostic& warning : warnings_) text += told(warning, "warning");
  return text;
}

void Diagnostics::throw_if_any() const {
  if (none()) return;
  std::string message = text();
  message += fmt::format("{} mistake{} in {}", count(), count() == 1 ? "" : "s", file_);
  throw UserError(message);
}

}  // namespace striate::config
