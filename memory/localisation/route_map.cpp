#include "striate/memory/localisation/route_map.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "striate/base/geometry.hpp"

namespace striate::memory {
namespace {

// "By hand": memory/README.md, "Where the numbers come from".

constexpr double kPathShare = 0.01;     // error of a driven distance: the base's 0.75 %, and more
constexpr double kStation_m = 0.3;      ///< by hand: and where the stations' nearest points lay
constexpr double kTurnSigma_rad = 0.1;  ///< by hand, 6 degrees: how the robot swings as it passes
constexpr double kMostLooks = 10.0;     ///< by hand: more drives make a stretch no surer
constexpr double kBackwardsCost = 1.2;  ///< by hand: of a stretch never driven in this direction
constexpr double kTrustBefore = 1.0;    ///< Laplace's rule of succession: one success, one failure

/// Distance, made longer by its doubt and divided by the chance of success.
double cost_of(const Route& route) {
  const double tries = static_cast<double>(route.successes + route.failures) + 2.0 * kTrustBefore;
  const double chance = (static_cast<double>(route.successes) + kTrustBefore) / tries;
  return (route.distance_m + std::sqrt(route.distance_var_m2)) / chance;
}

/// The average of two measurements by their variances.
void join(double& value, double& variance, double difference, double variance_new) {
  const double gain = variance / std::max(1e-12, variance + variance_new);
  value += gain * difference;
  variance *= 1.0 - gain;
}

}  // namespace

RouteMap::RouteMap() {
  routes_.reserve(kRoutes);
  changed_.reserve(kRoutes);
  stations_.reserve(kStations);
}

void RouteMap::know(std::span<const Route> routes) {
  for (const Route& route : routes) add(route);
}

bool RouteMap::add(const Route& route) {
  if (route.from == route.to || routes_.size() >= kRoutes) return false;
  for (const std::int64_t end : {route.from, route.to}) {
    if (station_of(end) >= 0) continue;
    if (stations_.size() >= kStations) return false;
    stations_.push_back(end);
  }
  routes_.push_back(route);
  changed_.push_back(false);
  return true;
}

int RouteMap::station_of(std::int64_t landmark) const {
  const auto found = std::find(stations_.begin(), stations_.end(), landmark);
  return found == stations_.end() ? -1 : static_cast<int>(found - stations_.begin());
}

const Route* RouteMap::find(std::int64_t from, std::int64_t to) const {
  const auto found = std::find_if(routes_.begin(), routes_.end(), [&](const Route& route) {
    return route.from == from && route.to == to;
  });
  return found == routes_.end() ? nullptr : &*found;
}

void RouteMap::driven(std::int64_t from, std::int64_t to, double distance_m, double turn_rad) {
  const double sigma_m = std::hypot(kPathShare * distance_m, kStation_m);
  const double turn_var_rad2 = kTurnSigma_rad * kTurnSigma_rad;
  for (std::size_t k = 0; k < routes_.size(); ++k) {
    Route& route = routes_[k];
    if (route.from != from || route.to != to) continue;
    join(route.distance_m, route.distance_var_m2, distance_m - route.distance_m, sigma_m * sigma_m);
    join(route.turn_rad, route.turn_var_rad2, wrap_angle(turn_rad - route.turn_rad), turn_var_rad2);
    route.turn_rad = wrap_angle(route.turn_rad);
    // What is never seen to vary still differs from drive to drive.
    route.distance_var_m2 = std::max(route.distance_var_m2, kStation_m * kStation_m / kMostLooks);
    route.turn_var_rad2 = std::max(route.turn_var_rad2, turn_var_rad2 / kMostLooks);
    ++route.successes;
    changed_[k] = true;
    return;
  }
  if (add({from, to, distance_m, wrap_angle(turn_rad), sigma_m * sigma_m, turn_var_rad2, 1, 0})) {
    changed_.back() = true;
  }
}

void RouteMap::failed(std::int64_t from, std::int64_t to) {
  for (std::size_t k = 0; k < routes_.size(); ++k) {
    if (routes_[k].from != from || routes_[k].to != to) continue;
    ++routes_[k].failures;
    changed_[k] = true;
  }
}

RoutePlan RouteMap::path_to(std::int64_t from, std::int64_t to) const {
  RoutePlan way;
  const int start = station_of(from);
  const int goal = station_of(to);
  if (from == to && from != 0) way.found = true;
  if (start < 0 || goal < 0 || from == to) return way;

  struct Reached {
    double cost = std::numeric_limits<double>::infinity();
    int before = -1;
    int route = -1;
    bool backwards = false;
    bool done = false;
  };
  std::array<Reached, kStations> reached;
  const auto at = [&](int station) -> Reached& {
    return reached[static_cast<std::size_t>(station)];
  };
  at(start).cost = 0.0;
  while (true) {
    int nearest = -1;
    for (int k = 0; k < static_cast<int>(stations_.size()); ++k) {
      if (at(k).done || !std::isfinite(at(k).cost)) continue;
      if (nearest < 0 || at(k).cost < at(nearest).cost) nearest = k;
    }
    if (nearest < 0 || nearest == goal) break;
    at(nearest).done = true;
    const std::int64_t here = stations_[static_cast<std::size_t>(nearest)];
    for (std::size_t r = 0; r < routes_.size(); ++r) {
      const Route& route = routes_[r];
      if (route.from != here && route.to != here) continue;
      const bool backwards = route.from != here;
      Reached& next = at(station_of(backwards ? route.from : route.to));
      const double cost = at(nearest).cost + cost_of(route) * (backwards ? kBackwardsCost : 1.0);
      if (cost < next.cost) next = {cost, nearest, static_cast<int>(r), backwards, next.done};
    }
  }
  for (int station = goal; station != start; station = at(station).before) {
    if (at(station).before < 0 || way.size == RoutePlan::kMost) return {};
    const Route& route = routes_[static_cast<std::size_t>(at(station).route)];
    const bool backwards = at(station).backwards;
    way.steps[way.size++] = {backwards ? route.from : route.to, route.distance_m,
                             std::sqrt(route.distance_var_m2),
                             backwards ? -route.turn_rad : route.turn_rad, backwards};
    way.distance_m += route.distance_m;
  }
  std::reverse(way.steps.begin(), way.steps.begin() + static_cast<std::ptrdiff_t>(way.size));
  way.found = true;
  return way;
}

}  // namespace striate::memory
