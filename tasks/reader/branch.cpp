#include "striate/tasks/reader/branch.hpp"

#include <fmt/format.h>

#include "striate/tasks/fault.hpp"

namespace striate::tasks {
namespace {

/// Tells the step behind the first that lets nothing follow; what stands behind it is the same
/// mistake.
template <class Blocks>
void tell_first_unreachable(const std::vector<Branch>& steps, const Blocks& blocks, const char* why,
                            const char* hint, config::Diagnostics& diagnostics) {
  for (std::size_t i = 0; i + 1 < steps.size(); ++i) {
    if (!blocks(steps[i].flow)) continue;
    const Outline& before = steps[i].outline;
    diagnostics.add(fault::unreachable, steps[i + 1].outline.place,
                    fmt::format("this step is never reached: {} in line {} {}", before.name,
                                before.place.line, why),
                    hint);
    return;
  }
}

}  // namespace

Children take(std::vector<Branch> branches) {
  Children children;
  for (Branch& branch : branches) {
    children.nodes.push_back(std::move(branch.node));
    children.outlines.push_back(std::move(branch.outline));
  }
  return children;
}

Flow flow_of_sequence(const std::vector<Branch>& steps) {
  Flow flow{true, false, !steps.empty(), behaviours::Motors::nothing};
  for (const Branch& step : steps) {
    flow.succeeds = flow.succeeds && step.flow.lets_next_begin();
    flow.fails = flow.fails || step.flow.fails;
    flow.skips = flow.skips && step.flow.skips;
    flow.motors = flow.motors | step.flow.motors;
  }
  return flow;
}

Flow flow_of_try(const std::vector<Branch>& steps) {
  Flow flow{false, true, true, behaviours::Motors::nothing};
  for (const Branch& step : steps) {
    flow.succeeds = flow.succeeds || step.flow.succeeds;
    flow.fails = flow.fails && (step.flow.fails || step.flow.skips);
    flow.skips = flow.skips && step.flow.skips;
    flow.motors = flow.motors | step.flow.motors;
  }
  return flow;
}

Flow flow_of_together(const std::vector<Branch>& steps) {
  return flow_of_sequence(steps);
}

void check_sequence(const std::vector<Branch>& steps, bool keep_going,
                    config::Diagnostics& diagnostics) {
  tell_first_unreachable(
      steps,
      [&](const Flow& flow) { return !flow.lets_next_begin() && !(keep_going && flow.fails); },
      "never succeeds, it goes on until it is halted or fails", "give that step an 'until:'",
      diagnostics);
}

void check_try(const std::vector<Branch>& steps, config::Diagnostics& diagnostics) {
  tell_first_unreachable(
      steps, [](const Flow& flow) { return !flow.fails && !flow.skips; }, "never fails",
      "put what always works last", diagnostics);
}

void check_together(const std::vector<Branch>& steps, config::Diagnostics& diagnostics) {
  for (std::size_t i = 1; i < steps.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if (!behaviours::share(steps[i].flow.motors, steps[k].flow.motors)) continue;
      const bool wheels = behaviours::share(behaviours::Motors::wheels, steps[i].flow.motors) &&
                          behaviours::share(behaviours::Motors::wheels, steps[k].flow.motors);
      diagnostics.add(
          fault::same_motors, steps[i].outline.place,
          fmt::format("{} wants the {}, and so does {} in line {}", steps[i].outline.name,
                      wheels ? "wheels" : "head", steps[k].outline.name,
                      steps[k].outline.place.line),
          "put them one after the other: only one of 'together' may move the same part");
      break;
    }
  }
}

}  // namespace striate::tasks
