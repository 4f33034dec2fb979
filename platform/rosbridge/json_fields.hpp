#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

/// Fields of a message that came over the network: whatever stands there, a value or a sentence.
namespace striate::rosbridge {

/// A message that cannot be used; what() says which field and why.
class BadMessage : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Reads one JSON object. @throws BadMessage where it is none, or nested deeper than any message of
/// ROS that is heard
[[nodiscard]] nlohmann::json read_object(std::string_view text);

/// The field at a dotted path, "pose.pose.position". @throws BadMessage where it is missing
[[nodiscard]] const nlohmann::json& field_at(const nlohmann::json& message, std::string_view path);

/// @throws BadMessage where it is no finite number
[[nodiscard]] double number_at(const nlohmann::json& message, std::string_view path);
/// @throws BadMessage where it is no whole number from 0 to `most`
[[nodiscard]] std::int64_t count_at(const nlohmann::json& message, std::string_view path,
                                    std::int64_t most);
/// @throws BadMessage where it is no text
[[nodiscard]] const std::string& text_at(const nlohmann::json& message, std::string_view path);
/// Numbers, where what is none becomes not a number: so rosbridge writes infinity, too.
/// @throws BadMessage where it is no list, or of more than `most`
[[nodiscard]] std::vector<double> numbers_at(const nlohmann::json& message, std::string_view path,
                                             std::size_t most);
/// The bytes of a `uint8[]`: base64 as rosbridge writes it, or a list of numbers.
/// @throws BadMessage where it is neither
[[nodiscard]] std::vector<std::uint8_t> bytes_at(const nlohmann::json& message,
                                                 std::string_view path);

}  // namespace striate::rosbridge
