#include "striate/app/memory/json_number.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace striate::app {
namespace {

/// An export: table, row, list of a row, row of that, list of numbers
constexpr int kDeepestNesting = 8;

double number_within(const nlohmann::ordered_json& value, const char* key, NumberRange range) {
  if (!value.is_number()) throw std::invalid_argument(fmt::format("'{}' is no number", key));
  const auto number = value.get<double>();
  if (number >= range.least && number <= range.most) return number;
  throw std::invalid_argument(fmt::format("'{}' is {:.6g}; {:.6g} to {:.6g} can be taken over", key,
                                          number, range.least, range.most));
}

}  // namespace

double real_at(const nlohmann::ordered_json& json, const char* key, NumberRange range) {
  return number_within(json.at(key), key, range);
}

std::optional<double> maybe_real_at(const nlohmann::ordered_json& json, const char* key,
                                    NumberRange range) {
  const nlohmann::ordered_json& value = json.at(key);
  return value.is_null() ? std::nullopt : std::optional(number_within(value, key, range));
}

std::int64_t whole_at(const nlohmann::ordered_json& json, const char* key, NumberRange range) {
  const double number = real_at(json, key, range);
  if (number == std::floor(number)) return static_cast<std::int64_t>(number);
  throw std::invalid_argument(fmt::format("'{}' is {:.6g}, which is no whole number", key, number));
}

nlohmann::ordered_json parse_shallow(const std::string& text) {
  const auto shallow = [](int depth, nlohmann::ordered_json::parse_event_t /*event*/,
                          nlohmann::ordered_json& /*parsed*/) {
    if (depth > kDeepestNesting) throw std::invalid_argument("it is nested deeper than any export");
    return true;
  };
  return nlohmann::ordered_json::parse(text, shallow);
}

}  // namespace striate::app
