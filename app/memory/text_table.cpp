#include "striate/app/memory/text_table.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <numeric>

namespace striate::app {
namespace {

constexpr int kGap = 2;        // blanks between columns
constexpr int kNarrowest = 4;  // letters: a column that is cut shorter says nothing

/// Letters, not bytes, of UTF-8.
int letters(const std::string& text) {
  return static_cast<int>(std::count_if(text.begin(), text.end(), [](char letter) {
    return (static_cast<unsigned char>(letter) & 0xC0) != 0x80;
  }));
}

std::string cut(const std::string& text, int width) {
  if (letters(text) <= width) return text;
  std::size_t at = 0;
  for (int count = 0; at < text.size(); ++at) {
    const bool starts = (static_cast<unsigned char>(text[at]) & 0xC0) != 0x80;
    if (starts && count++ == width - 1) break;
  }
  return text.substr(0, at) + "…";
}

std::string padded(const std::string& text, int width, bool right) {
  const std::string blanks(static_cast<std::size_t>(std::max(0, width - letters(text))), ' ');
  return right ? blanks + text : text + blanks;
}

}  // namespace

int terminal_width() {
  if (const char* given = std::getenv("COLUMNS"); given != nullptr && std::atoi(given) > 0) {
    return std::max(20, std::atoi(given));
  }
  winsize size{};
  if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0) {
    return std::max<int>(20, size.ws_col);
  }
  return 100;
}

TextTable::TextTable(const std::vector<std::string>& heads) {
  rows_.emplace_back();
  for (const std::string& head : heads) {
    right_.push_back(!head.empty() && head.front() == '>');
    rows_.front().push_back(right_.back() ? head.substr(1) : head);
  }
}

void TextTable::add(std::vector<std::string> cells) {
  cells.resize(right_.size());
  for (std::string& cell : cells) {
    std::replace_if(
        cell.begin(), cell.end(),
        [](char letter) { return static_cast<unsigned char>(letter) < 32; }, ' ');
  }
  rows_.push_back(std::move(cells));
}

/// Heads give way first, then the widest columns.
std::vector<int> TextTable::fitted_widths(int width) const {
  std::vector<int> widths(right_.size(), 0);
  std::vector<int> bodies(right_.size(), 0);
  for (std::size_t r = 0; r < rows_.size(); ++r) {
    for (std::size_t k = 0; k < widths.size(); ++k) {
      widths[k] = std::max(widths[k], letters(rows_[r][k]));
      if (r > 0) bodies[k] = std::max(bodies[k], letters(rows_[r][k]));
    }
  }
  const int gaps = kGap * (static_cast<int>(widths.size()) - 1);
  while (std::accumulate(widths.begin(), widths.end(), gaps) > width) {
    std::size_t gives = 0;
    int most = 0;
    for (std::size_t k = 0; k < widths.size(); ++k) {
      const int overhang = widths[k] - std::max(bodies[k], 2);
      if (overhang > most) {
        most = overhang;
        gives = k;
      }
    }
    if (most == 0) {
      gives =
          static_cast<std::size_t>(std::max_element(widths.begin(), widths.end()) - widths.begin());
      if (widths[gives] <= kNarrowest) break;
    }
    --widths[gives];
  }
  return widths;
}

std::string TextTable::print(int width) const {
  const std::vector<int> widths = fitted_widths(width);
  std::string text;
  for (const auto& row : rows_) {
    std::string line;
    for (std::size_t k = 0; k < row.size(); ++k) {
      if (k > 0) line += std::string(kGap, ' ');
      line += padded(cut(row[k], widths[k]), widths[k], right_[k]);
    }
    // Where even the narrowest columns are too wide, the line itself is cut.
    line = cut(line, width);
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  }
  return text;
}

}  // namespace striate::app
