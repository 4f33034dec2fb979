#include "striate/app/command_line/whole_number.hpp"

#include <fmt/format.h>

#include <charconv>
#include <limits>

namespace striate::app {
namespace {

constexpr std::uint64_t kHigh = std::numeric_limits<std::uint64_t>::max();

}  // namespace

CLI::Validator whole_number_from(std::uint64_t low) {
  const auto judge = [low](const std::string& text) -> std::string {
    std::uint64_t value = 0;
    const char* end = text.data() + text.size();
    const auto [stopped_at, error] = std::from_chars(text.data(), end, value);
    if (error == std::errc{} && stopped_at == end && value >= low) return {};
    return fmt::format("'{}' is no whole number from {} to {}", text, low, kHigh);
  };
  return CLI::Validator(judge, fmt::format("{}..{}", low, kHigh));
}

}  // namespace striate::app
