#include "striate/perception/descriptor/striate_table.hpp"

#include <fmt/format.h>

#include <sstream>

#include "striate/base/user_error.hpp"

namespace striate::perception {
namespace {

// The file is a raw string literal, so that it is both readable and part of the program.
constexpr const char* kShipped =
#include "striate/perception/descriptor/striate_256.inc"
    ;

/// Thousandths of the mean: 100 times the mean response, more than any patch has
constexpr int kLargestThreshold = 100000;

bool is_comment(const std::string& line) {
  return line.find_first_not_of(" \t\r") == std::string::npos || line.starts_with('#') ||
         line.starts_with("R\"") || line.starts_with(")\"");
}

bool in_range(const StriateBit& bit) {
  auto value = [](int number) { return number >= 0 && number < kPooledValues; };
  return value(bit.first) && value(bit.second) && bit.first != bit.second &&
         bit.threshold >= -kLargestThreshold && bit.threshold <= kLargestThreshold;
}

}  // namespace

StriateTable parse_striate_table(const std::string& text, const std::string& name) {
  StriateTable table;
  std::istringstream lines(text);
  std::size_t bits = 0;
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    if (is_comment(line)) continue;
    std::istringstream words(line);
    StriateBit bit;
    std::string more;
    if (!(words >> bit.first >> bit.second >> bit.threshold) || words >> more || !in_range(bit)) {
      throw UserError(
          fmt::format("{}:{}: error: expected two different pooled responses 0 to {} and a "
                      "threshold of at most {} thousandths",
                      name, number, kPooledValues - 1, kLargestThreshold));
    }
    if (bits == table.size()) {
      throw UserError(fmt::format("{}:{}: error: more than 256 bits", name, number));
    }
    table[bits++] = bit;
  }
  if (bits < table.size()) {
    throw UserError(fmt::format("{}:{}: error: only {} of 256 bits", name, number, bits));
  }
  return table;
}

const StriateTable& shipped_striate_table() {
  static const StriateTable table = parse_striate_table(kShipped, "striate_256.inc");
  return table;
}

std::string striate_table_text(const std::vector<StriateBit>& bits, const std::string& header) {
  std::string text = "R\"(\n" + header;
  for (const StriateBit& bit : bits) {
    text += fmt::format("{} {} {}\n", bit.first, bit.second, bit.threshold);
  }
  return text + ")\"\n";
}

}  // namespace striate::perception
