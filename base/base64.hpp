#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

/// Bytes as letters that JSON carries: RFC 4648, section 4.
namespace striate {

[[nodiscard]] std::string to_base64(std::span<const std::uint8_t> bytes);

/// Ends at the first '='. @throws std::invalid_argument for letters that are no base64.
[[nodiscard]] std::vector<std::uint8_t> from_base64(const std::string& text);

}  // namespace striate
