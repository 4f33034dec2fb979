#include "striate/config/quantity.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "striate/base/geometry.hpp"

namespace striate::config {
namespace {

struct UnitName {
  Unit unit;
  const char* name;
  double to_si;
};

constexpr double kDegree = radians(1.0);  // a degree in radians

/// The first name of each unit is the one that is printed.
constexpr UnitName kUnitNames[] = {
    {Unit::length, "m", 1.0},
    {Unit::length, "cm", 0.01},
    {Unit::length, "mm", 0.001},
    {Unit::duration, "s", 1.0},
    {Unit::duration, "ms", 0.001},
    {Unit::duration, "min", 60.0},
    {Unit::duration, "h", 3600.0},
    {Unit::angle, "deg", kDegree},
    {Unit::angle, "rad", 1.0},
    {Unit::speed, "m/s", 1.0},
    {Unit::speed, "cm/s", 0.01},
    {Unit::speed, "mm/s", 0.001},
    {Unit::turn_rate, "deg/s", kDegree},
    {Unit::turn_rate, "rad/s", 1.0},
    {Unit::acceleration, "m/s2", 1.0},
    {Unit::acceleration, "m/s^2", 1.0},
    {Unit::turn_acceleration, "deg/s2", kDegree},
    {Unit::turn_acceleration, "rad/s2", 1.0},
    {Unit::rate, "per s", 1.0},
    {Unit::rate, "per min", 1.0 / 60.0},
    {Unit::rate, "Hz", 1.0},
    {Unit::fraction, "%", 0.01},
    {Unit::pixels, "px", 1.0},
};

const char* example(Unit unit) {
  switch (unit) {
    case Unit::length:
      return "a length like '1.5 m' or '30 cm'";
    case Unit::duration:
      return "a duration like '4 min', '30 s' or '250 ms'";
    case Unit::angle:
      return "an angle like '60 deg' or '1.2 rad'";
    case Unit::speed:
      return "a speed like '0.4 m/s'";
    case Unit::turn_rate:
      return "a turning speed like '45 deg/s'";
    case Unit::acceleration:
      return "an acceleration like '0.5 m/s2'";
    case Unit::turn_acceleration:
      return "a turning acceleration like '90 deg/s2'";
    case Unit::rate:
      return "a rate like '2 per min'";
    case Unit::fraction:
      return "a fraction like '20 %' or '0.2'";
    case Unit::pixels:
      return "a number of pixels like '150 px'";
    case Unit::none:
      break;
  }
  return "a number";
}

std::string units_of(Unit unit) {
  std::string names;
  for (const UnitName& name : kUnitNames) {
    if (name.unit == unit) names += (names.empty() ? "" : ", ") + std::string(name.name);
  }
  return names;
}

const UnitName* find_unit(Unit unit, std::string_view name) {
  for (const UnitName& candidate : kUnitNames) {
    if (candidate.unit == unit && name == candidate.name) return &candidate;
  }
  return nullptr;
}

bool is_unit_of_another_kind(std::string_view name) {
  for (const UnitName& candidate : kUnitNames) {
    if (name == candidate.name) return true;
  }
  return false;
}

std::string trim(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return std::string(text);
}

/// Numbers as people write them: no leading zeros (010 is 8 to some readers), no hex, NaN, inf.
std::optional<double> parse_number(std::string_view text, std::string_view& rest) {
  std::size_t begin = 0;
  if (begin < text.size() && (text[begin] == '-' || text[begin] == '+')) ++begin;
  if (begin >= text.size() || text[begin] < '0' || text[begin] > '9') return std::nullopt;
  if (text[begin] == '0' && begin + 1 < text.size() && text[begin + 1] >= '0' &&
      text[begin + 1] <= '9') {
    return std::nullopt;
  }
  double value = 0.0;
  const char* first = text.data() + (text[0] == '+' ? 1 : 0);
  const auto [end, code] = std::from_chars(first, text.data() + text.size(), value);
  if (code != std::errc{}) return std::nullopt;
  rest = text.substr(static_cast<std::size_t>(end - text.data()));
  return value;
}

/// The factor to SI of the unit that is written, or nothing with a mistake added.
std::optional<double> unit_factor(const Node& node, Unit unit, const std::string& written,
                                  Diagnostics& diagnostics) {
  if (unit == Unit::none) {
    if (written.empty()) return 1.0;
    diagnostics.add(fault::wrong_unit, node.place,
                    fmt::format("'{}' has a unit, but a plain number is wanted", node.text),
                    fmt::format("leave '{}' away", written));
    return std::nullopt;
  }
  if (written.empty()) {
    if (unit == Unit::fraction) return 1.0;
    diagnostics.add(fault::no_unit, node.place, fmt::format("'{}' has no unit", node.text),
                    fmt::format("write {}", example(unit)));
    return std::nullopt;
  }
  if (const UnitName* name = find_unit(unit, written)) return name->to_si;
  const char* kind = is_unit_of_another_kind(written) ? "the wrong unit" : "an unknown unit";
  diagnostics.add(fault::wrong_unit, node.place, fmt::format("'{}' has {}", node.text, kind),
                  fmt::format("write {} (units: {})", example(unit), units_of(unit)));
  return std::nullopt;
}

}  // namespace

std::optional<double> read_quantity(const Node& node, Unit unit, Range range,
                                    Diagnostics& diagnostics) {
  if (node.open) return std::nullopt;
  std::string_view rest;
  std::optional<double> number;
  if (node.kind == Node::Kind::scalar && !node.quoted) number = parse_number(node.text, rest);
  if (!number) {
    const bool zero_first = node.text.size() > 1 && node.text[0] == '0' && !node.quoted;
    diagnostics.add(fault::no_number, node.place,
                    fmt::format("{} is not {}", node.describe(), example(unit)),
                    zero_first ? "a number does not begin with 0: some would read 010 as 8" : "");
    return std::nullopt;
  }
  const std::optional<double> factor = unit_factor(node, unit, trim(rest), diagnostics);
  if (!factor) return std::nullopt;
  const double value = *number * *factor;
  if (!std::isfinite(value) || value < range.low || value > range.high) {
    diagnostics.add(fault::out_of_range, node.place, fmt::format("'{}' is out of range", node.text),
                    fmt::format("allowed is {} to {}", print_quantity(range.low, unit),
                                print_quantity(range.high, unit)));
    return std::nullopt;
  }
  return value;
}

std::string print_quantity(double value_si, Unit unit) {
  if (unit == Unit::none) return fmt::format("{:.10g}", value_si);
  for (const UnitName& name : kUnitNames) {
    if (name.unit == unit) return fmt::format("{:.10g} {}", value_si / name.to_si, name.name);
  }
  return fmt::format("{:.10g}", value_si);
}

}  // namespace striate::config
