#include "striate/config/settings.hpp"

#include <fmt/format.h>

namespace striate::config {

void SettingsPrinter::number(const char* key, double& field, Unit unit, Range range,
                             const char* help) {
  lines_.push_back(
      {prefix_ + key, print_quantity(field, unit),
       fmt::format("{} .. {}", print_quantity(range.low, unit), print_quantity(range.high, unit)),
       help});
}

void SettingsPrinter::integer(const char* key, int& field, Range range, const char* help) {
  lines_.push_back({prefix_ + key, fmt::format("{}", field),
                    fmt::format("{} .. {}", range.low, range.high), help});
}

void SettingsPrinter::flag(const char* key, bool& field, const char* help) {
  lines_.push_back({prefix_ + key, field ? "true" : "false", "true, false", help});
}

void SettingsPrinter::text(const char* key, std::string& field, const char* help) {
  lines_.push_back({prefix_ + key, field, "any text", help});
}

void SettingsPrinter::add_choice(const char* key, int index, const std::vector<std::string>& names,
                                 const char* help) {
  lines_.push_back({prefix_ + key, names.at(static_cast<std::size_t>(index)),
                    fmt::format("{}", fmt::join(names, ", ")), help});
}

}  // namespace striate::config
