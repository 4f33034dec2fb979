#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "striate/memory/long_term/long_term_settings.hpp"
#include "striate/memory/long_term/records.hpp"

namespace striate::memory {

/// What is going on now: it spreads activation to what belongs to it.
struct Situation {
  double now_s = 0.0;                  ///< operating time
  std::int64_t goal = 0;               ///< landmark that the task is after; 0: none
  std::vector<std::int64_t> in_sight;  ///< landmarks seen now
};

/// Base-level activation of ACT-R in Petrov's hybrid form: the last k <= 10 of n uses exactly, the
/// older ones as if spread evenly since the first use, L ago (Petrov 2006):
///   B = ln[ sum_{j<=k} t_j^-d + (n-k) (L^(1-d) - t_k^(1-d)) / ((1-d) (L - t_k)) ]
/// Uses nearer than a second count as a second ago. Never used: minus infinity.
[[nodiscard]] double base_level(const UseHistory& history, double now_s, double decay);

/// The same landmark used once more, now.
void note_use(UseHistory& history, double now_s);

/// A confirmed sighting: s + 0.25 (1 - s). A missed opportunity: 0.9 s. Both stay within (0, 1).
[[nodiscard]] double consolidated(double strength, const LongTermSettings& settings);
[[nodiscard]] double enfeebled(double strength, const LongTermSettings& settings);

/// The parts of a total activation.
struct Activation {
  double base = 0.0;
  double goal = 0.0;
  double route = 0.0;
  double strength = 0.0;  ///< ln(s / (1 - s))
  [[nodiscard]] double total() const { return base + goal + route + strength; }
};

/// A = B + spread from the goal and from neighbours on the route + ln(s / (1 - s)). A route
/// spreads by the share of its successes, (successes + 1) / (tries + 2); the best one counts.
[[nodiscard]] Activation activation_of(const Landmark& landmark, const Situation& situation,
                                       const std::vector<Route>& routes,
                                       const LongTermSettings& settings);

/// The same in words and numbers, a line each.
[[nodiscard]] std::vector<std::string> explain(const Landmark& landmark, const Situation& situation,
                                               const std::vector<Route>& routes,
                                               const LongTermSettings& settings);

/// "12 s", "5 min", "3.2 h", "4.1 days".
[[nodiscard]] std::string print_time_span(double span_s);

}  // namespace striate::memory
