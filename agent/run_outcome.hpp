#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace striate::agent {

/// What came of a run. Tasks and the simulator have narrower outcomes of their own.
enum class RunOutcome : std::uint8_t {
  success,
  collision,
  task_failed,
  task_ended,
  time_over,
  body_ended,
  interrupted,
  lost
};

/// One row of the table of outcomes: all that depends on the outcome alone.
struct OutcomeRow {
  RunOutcome outcome;
  std::string_view name;  ///< in JSON, CSV, tables and the long-term memory; never changes
  int exit_code;          ///< what `striate` ends with
  bool finished;          ///< it counts in a trial; else the run is to be made again
  bool failed;            ///< the mission itself did not come to what it was after
  std::string_view meaning;
};

/// Every outcome, in the order of the enum.
[[nodiscard]] std::span<const OutcomeRow> all_outcomes();
[[nodiscard]] const OutcomeRow& row_of(RunOutcome outcome);
[[nodiscard]] inline std::string_view name_of(RunOutcome outcome) {
  return row_of(outcome).name;
}
/// nullopt for a name that is none.
[[nodiscard]] std::optional<RunOutcome> outcome_named(std::string_view name);

}  // namespace striate::agent
