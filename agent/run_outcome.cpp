#include "striate/agent/run_outcome.hpp"

#include <algorithm>
#include <array>

namespace striate::agent {
namespace {

constexpr int kInterrupted = 130;  // 128 + SIGINT, as shells have it

// clang-format off
constexpr std::array<OutcomeRow, 8> kRows = {{
  //                                        exit code   finished  failed
  {RunOutcome::success,     "success",      0,            true,   false, "the goal was reached, and nothing was touched"},
  {RunOutcome::collision,   "collision",    1,            true,   true,  "the judge saw a touch"},
  {RunOutcome::task_failed, "task_failed",  1,            true,   true,  "a step failed, or a guard ended the task"},
  {RunOutcome::task_ended,  "task_ended",   1,            true,   true,  "the steps are done, but the goal line was not crossed"},
  {RunOutcome::time_over,   "time_over",    1,            true,   true,  "the judge's time limit has passed"},
  {RunOutcome::body_ended,  "body_ended",   1,            true,   true,  "the body gave no more senses: a bag or a recording is over"},
  {RunOutcome::interrupted, "interrupted",  kInterrupted, false,  false, "somebody ended it from outside"},
  {RunOutcome::lost,        "lost",         1,            false,  true,  "the body or the mind threw an error"},
}};
// clang-format on

}  // namespace

std::span<const OutcomeRow> all_outcomes() {
  return kRows;
}

const OutcomeRow& row_of(RunOutcome outcome) {
  return kRows.at(static_cast<std::size_t>(outcome));
}

std::optional<RunOutcome> outcome_named(std::string_view name) {
  const auto row = std::ranges::find(kRows, name, &OutcomeRow::name);
  if (row == kRows.end()) return std::nullopt;
  return row->outcome;
}

}  // namespace striate::agent
