#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>

namespace striate::app {

/// Refuses what is no whole number of 64 bits from `low` on, and says which are.
[[nodiscard]] CLI::Validator whole_number_from(std::uint64_t low);

}  // namespace striate::app
