#include "striate/memory/long_term/activation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace striate::memory {
namespace {

constexpr double kNearest_s = 1.0;  ///< by hand: at an age of 0 the power would be infinite
constexpr double kEdge = 1e-6;      ///< by hand: strength keeps so far away from 0 and 1

double age_s(double now_s, double then_s) {
  return std::max(now_s - then_s, kNearest_s);
}

bool contains(const std::vector<std::int64_t>& all, std::int64_t one) {
  return std::find(all.begin(), all.end(), one) != all.end();
}

}  // namespace

double base_level(const UseHistory& history, double now_s, double decay) {
  const std::size_t kept =
      std::min({history.recent_s.size(), UseHistory::kKept,
                static_cast<std::size_t>(std::max<std::int64_t>(history.uses, 0))});
  if (kept == 0) return -std::numeric_limits<double>::infinity();
  double sum = 0.0;
  for (std::size_t j = 0; j < kept; ++j) {
    sum += std::pow(age_s(now_s, history.recent_s[j]), -decay);
  }
  const double older = static_cast<double>(history.uses) - static_cast<double>(kept);
  if (older > 0.0) {
    const double oldest_kept_s = age_s(now_s, history.recent_s[kept - 1]);
    const double life_s = age_s(now_s, history.first_s);
    const double power = 1.0 - decay;
    // Where all uses fell together the fraction is 0 / 0; its limit is t^-d.
    sum += life_s - oldest_kept_s > 1e-6
               ? older * (std::pow(life_s, power) - std::pow(oldest_kept_s, power)) /
                     (power * (life_s - oldest_kept_s))
               : older * std::pow(oldest_kept_s, -decay);
  }
  return std::log(sum);
}

void note_use(UseHistory& history, double now_s) {
  if (history.uses == 0) history.first_s = now_s;
  ++history.uses;
  history.recent_s.insert(history.recent_s.begin(), now_s);
  if (history.recent_s.size() > UseHistory::kKept) history.recent_s.resize(UseHistory::kKept);
}

double consolidated(double strength, const LongTermSettings& settings) {
  return std::clamp(strength + settings.consolidation * (1.0 - strength), kEdge, 1.0 - kEdge);
}

double enfeebled(double strength, const LongTermSettings& settings) {
  return std::clamp(strength * settings.enfeeblement, kEdge, 1.0 - kEdge);
}

Activation activation_of(const Landmark& landmark, const Situation& situation,
                         const std::vector<Route>& routes, const LongTermSettings& settings) {
  Activation parts;
  parts.base = base_level(landmark.history, situation.now_s, settings.decay);
  if (situation.goal == landmark.id && landmark.id != 0) parts.goal = settings.goal_spread;
  for (const Route& route : routes) {
    if (route.to != landmark.id || !contains(situation.in_sight, route.from)) continue;
    const double share = static_cast<double>(route.successes + 1) /
                         static_cast<double>(route.successes + route.failures + 2);
    parts.route = std::max(parts.route, settings.route_spread * share);
  }
  const double s = std::clamp(landmark.strength, kEdge, 1.0 - kEdge);
  parts.strength = std::log(s / (1.0 - s));
  return parts;
}

std::string print_time_span(double span_s) {
  if (span_s < 90.0) return fmt::format("{:.0f} s", span_s);
  if (span_s < 5400.0) return fmt::format("{:.0f} min", span_s / 60.0);
  if (span_s < 172800.0) return fmt::format("{:.1f} h", span_s / 3600.0);
  return fmt::format("{:.1f} days", span_s / 86400.0);
}

std::vector<std::string> explain(const Landmark& landmark, const Situation& situation,
                                 const std::vector<Route>& routes,
                                 const LongTermSettings& settings) {
  const Activation parts = activation_of(landmark, situation, routes, settings);
  const UseHistory& history = landmark.history;
  std::vector<std::string> lines;
  lines.push_back(
      fmt::format("'{}' has activation {:+.2f}: the higher, the earlier it is looked for.",
                  landmark.name, parts.total()));
  lines.push_back(
      history.uses == 0 || history.recent_s.empty()
          ? fmt::format("  {:+.2f}  it was never used.", parts.base)
          : fmt::format("  {:+.2f}  it was used {} time{}, last {} of work ago, first {} ago; uses "
                        "fade with the power {:.2f} of their age.",
                        parts.base, history.uses, history.uses == 1 ? "" : "s",
                        print_time_span(situation.now_s - history.recent_s.front()),
                        print_time_span(situation.now_s - history.first_s), settings.decay));
  lines.push_back(fmt::format(
      "  {:+.2f}  its strength is {:.2f}: {}.", parts.strength, landmark.strength,
      landmark.strength > settings.start_strength   ? "it was mostly there when it was expected"
      : landmark.strength < settings.start_strength ? "it was often missed where it was expected"
                                                    : "neither confirmed nor missed so far"));
  lines.push_back(parts.goal > 0.0 ? fmt::format("  {:+.2f}  the task is after it.", parts.goal)
                                   : fmt::format("  {:+.2f}  no task is after it.", 0.0));
  lines.push_back(
      parts.route > 0.0
          ? fmt::format("  {:+.2f}  a route leads there from what is in sight.", parts.route)
          : fmt::format("  {:+.2f}  no route leads there from what is in sight.", 0.0));
  return lines;
}

}  // namespace striate::memory
