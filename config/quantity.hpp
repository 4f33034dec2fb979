#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "striate/config/node.hpp"

namespace striate::config {

/// Kinds of physical quantities. Every number in a file has its unit; a pure count has none.
enum class Unit {
  none,               ///< a plain number
  length,             ///< m, cm, mm                    -> m
  duration,           ///< s, ms, min, h                -> s
  angle,              ///< deg, rad                     -> rad
  speed,              ///< m/s, cm/s, mm/s              -> m/s
  turn_rate,          ///< deg/s, rad/s                 -> rad/s
  acceleration,       ///< m/s2, m/s^2                  -> m/s^2
  turn_acceleration,  ///< deg/s2, rad/s2            -> rad/s^2
  rate,               ///< per min, per s, Hz           -> 1/s
  fraction,           ///< %, or a plain number         -> 0..1
  pixels,             ///< px                           -> px
};

struct Range {
  double low = 0.0;
  double high = 0.0;
};

/// Reads "0.4 m/s" as SI. Adds a mistake with a hint for a missing or wrong unit, NaN, infinity,
/// a number like 010, or a value outside `range` (inclusive, SI).
std::optional<double> read_quantity(const Node& node, Unit unit, Range range,
                                    Diagnostics& diagnostics);

/// The value as a person writes it: 0.4 -> "0.4 m/s", 1.5708 rad -> "90 deg".
std::string print_quantity(double value_si, Unit unit);

/// The nearest of `candidates` by edit distance, as "did you mean 'x'?"; empty if none is near.
std::string suggest(std::string_view wrong, const std::vector<std::string>& candidates);

}  // namespace striate::config
