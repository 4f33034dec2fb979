#pragma once

#include <fmt/format.h>

#include <string>
#include <vector>

#include "striate/base/user_error.hpp"
#include "striate/config/quantity.hpp"

namespace striate::python {

/// Visits a settings struct that Python has filled in: what a file may not say, code may not
/// either. @throws UserError for the first number out of its range
class RangeCheck {
 public:
  void number(const char* key, const double& value, config::Unit /*unit*/, config::Range range,
              const char* /*help*/) {
    check(key, value, range);
  }
  void integer(const char* key, const int& value, config::Range range, const char* /*help*/) {
    check(key, value, range);
  }
  void flag(const char* /*key*/, const bool& /*value*/, const char* /*help*/) {}
  template <class Enum>
  void choice(const char* /*key*/, const Enum& /*value*/, const std::vector<std::string>& /*names*/,
              const char* /*help*/) {}
  void renamed(const char* /*was*/, const char* /*now*/) {}

 private:
  static void check(const char* key, double value, config::Range range) {
    if (value >= range.low && value <= range.high) return;  // false for what is no number
    throw UserError(
        fmt::format("{} {:.6g}: must be {:.6g} to {:.6g}", key, value, range.low, range.high));
  }
};

template <class Settings>
Settings checked(Settings settings) {
  RangeCheck check;
  visit(check, settings);
  return settings;
}

}  // namespace striate::python
