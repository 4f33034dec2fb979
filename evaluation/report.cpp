#include "striate/evaluation/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace striate::evaluation {
namespace {

std::string quoted(const std::string& cell) {
  if (cell.find_first_of(",\"\n") == std::string::npos) return cell;
  std::string result = "\"";
  for (const char c : cell) result += c == '"' ? std::string("\"\"") : std::string(1, c);
  return result + '"';
}

}  // namespace

Report::Report(std::string title, std::vector<std::string> columns)
    : title_(std::move(title)), columns_(std::move(columns)) {}

void Report::add_row(std::vector<std::string> cells) {
  if (cells.size() != columns_.size()) {
    throw std::invalid_argument(fmt::format("Report: a row of {} cells in a table of {} columns",
                                            cells.size(), columns_.size()));
  }
  rows_.push_back(std::move(cells));
}

std::string Report::text() const {
  std::vector<std::size_t> widths;
  for (std::size_t k = 0; k < columns_.size(); ++k) {
    std::size_t width = columns_[k].size();
    for (const auto& row : rows_) width = std::max(width, row[k].size());
    widths.push_back(width);
  }
  std::string text = title_ + "\n";
  auto line = [&](const std::vector<std::string>& cells) {
    std::string result;
    for (std::size_t k = 0; k < cells.size(); ++k) {
      result += k == 0 ? fmt::format("{:<{}}", cells[k], widths[k])
                       : fmt::format("  {:>{}}", cells[k], widths[k]);
    }
    text += result + "\n";
  };
  line(columns_);
  for (const auto& row : rows_) line(row);
  return text;
}

std::string Report::csv() const {
  std::string csv;
  auto line = [&](const std::vector<std::string>& cells) {
    for (std::size_t k = 0; k < cells.size(); ++k) csv += (k == 0 ? "" : ",") + quoted(cells[k]);
    csv += "\n";
  };
  line(columns_);
  for (const auto& row : rows_) line(row);
  return csv;
}

}  // namespace striate::evaluation
