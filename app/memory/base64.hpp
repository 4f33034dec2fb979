#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace striate::app {

[[nodiscard]] std::string to_base64(std::span<const std::uint8_t> bytes);
/// @throws std::invalid_argument for letters that are no base64.
[[nodiscard]] std::vector<std::uint8_t> from_base64(const std::string& text);

}  // namespace striate::app
