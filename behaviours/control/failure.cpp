#include "striate/behaviours/control/failure.hpp"

#include <array>
#include <cstddef>

namespace striate::behaviours {

std::span<const FailureRow> all_failures() {
  static constexpr std::array<FailureRow, 8> rows{{
      {Failure::other, "other", "an action that gives no word, as those of plugins may"},
      {Failure::way_blocked, "way_blocked", "no way on, or none to where it should go"},
      {Failure::cannot_turn, "cannot_turn", "no room to turn on the spot"},
      {Failure::not_found, "not_found", "what it looked for is not in sight"},
      {Failure::not_known, "not_known", "the place or the floor that it needs is not known"},
      {Failure::head_stuck, "head_stuck", "the head does not go where it is told to"},
      {Failure::took_too_long, "took_too_long", "the time of its `within` is over"},
      {Failure::guard, "guard", "a `fail_if` of `always` held"},
  }};
  return rows;
}

std::string_view name_of(Failure failure) {
  return all_failures()[static_cast<std::size_t>(failure)].name;
}

}  // namespace striate::behaviours
