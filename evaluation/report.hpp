#pragma once

#include <string>
#include <vector>

namespace striate::evaluation {

/// A table that is printed for a person and written as CSV for a program.
class Report {
 public:
  Report(std::string title, std::vector<std::string> columns);

  /// As many cells as columns; else std::invalid_argument.
  void add_row(std::vector<std::string> cells);

  /// Columns aligned; the first one to the left, numbers to the right.
  [[nodiscard]] std::string text() const;
  [[nodiscard]] std::string csv() const;

 private:
  std::string title_;
  std::vector<std::string> columns_;
  std::vector<std::vector<std::string>> rows_;
};

}  // namespace striate::evaluation
