#pragma once

#include <string>
#include <vector>

namespace striate::app {

/// Columns of the terminal, or 100 where output goes elsewhere; COLUMNS in the environment wins.
[[nodiscard]] int terminal_width();

/// A table of text that fits a width: heads, then the widest columns are cut, with an ellipsis.
class TextTable {
 public:
  /// @param heads one a column; a leading '>' puts the column to the right, as for numbers.
  explicit TextTable(const std::vector<std::string>& heads);

  /// @param cells as many as heads; line breaks become blanks.
  void add(std::vector<std::string> cells);
  [[nodiscard]] bool empty() const { return rows_.size() == 1; }
  /// Lines of at most `width` letters, each with a line break.
  [[nodiscard]] std::string print(int width) const;

 private:
  [[nodiscard]] std::vector<int> fitted_widths(int width) const;

  std::vector<bool> right_;
  std::vector<std::vector<std::string>> rows_;  ///< the first are the heads
};

}  // namespace striate::app
