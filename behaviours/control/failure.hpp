#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace striate::behaviours {

/// Why something failed, as a word for programs; the sentence beside it is for people.
enum class Failure : std::uint8_t {
  other,
  way_blocked,
  cannot_turn,
  not_found,
  not_known,
  head_stuck,
  took_too_long,
  guard
};

/// One row of the table of failures.
struct FailureRow {
  Failure failure;
  std::string_view name;  ///< in JSON and CSV; never changes
  std::string_view meaning;
};

/// Every failure, in the order of the enum.
[[nodiscard]] std::span<const FailureRow> all_failures();
[[nodiscard]] std::string_view name_of(Failure failure);

}  // namespace striate::behaviours
