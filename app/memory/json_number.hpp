#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>

/// Numbers of somebody else's JSON, each within the bounds of what it says. The library converts
/// whatever stands there, and what does not fit into the type is undefined.
namespace striate::app {

/// What a number may be, both ends included.
struct NumberRange {
  double least = 0.0;
  double most = 0.0;
};

/// By hand: what no memory of a robot reaches, and what can still be added and squared.
namespace taken {
inline constexpr NumberRange kPlace_m{-1e6, 1e6};       ///< by hand: as far as odometry may tell
inline constexpr NumberRange kVariance{0.0, 1e12};      ///< kPlace_m squared
inline constexpr NumberRange kCovariance{-1e12, 1e12};  ///< kPlace_m squared
inline constexpr NumberRange kTime_s{-1e11, 1e11};      ///< by hand: 3000 years
inline constexpr NumberRange kAngle_rad{-1e3, 1e3};     ///< by hand: 160 turns
inline constexpr NumberRange kShare{0.0, 1.0};          ///< none and all
inline constexpr NumberRange kLogOdds{-1e3, 1e3};       ///< by hand: the table keeps 20 of them
inline constexpr NumberRange kSide_px{1.0, 16384.0};    ///< of the largest image that is read
inline constexpr NumberRange kCount{0.0, 1e12};         ///< by hand: a use a second, 30 000 years
inline constexpr NumberRange kCell{-1e7, 1e7};          ///< kPlace_m in cells of 0.1 m
inline constexpr NumberRange kId{-9e15, 9e15};          ///< whole numbers that a double holds
}  // namespace taken

/// @throws std::invalid_argument, which names `key`, for what is no number or lies outside
[[nodiscard]] double real_at(const nlohmann::ordered_json& json, const char* key,
                             NumberRange range);
/// null: none.
[[nodiscard]] std::optional<double> maybe_real_at(const nlohmann::ordered_json& json,
                                                  const char* key, NumberRange range);
/// @throws std::invalid_argument for what is no whole number, too
[[nodiscard]] std::int64_t whole_at(const nlohmann::ordered_json& json, const char* key,
                                    NumberRange range);

/// Reads JSON that is nested no deeper than any export, so that a file of nothing but brackets
/// takes no memory. @throws nlohmann::json::exception, std::invalid_argument
[[nodiscard]] nlohmann::ordered_json parse_shallow(const std::string& text);

}  // namespace striate::app
