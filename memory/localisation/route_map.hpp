#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "striate/memory/long_term/records.hpp"

namespace striate::memory {

/// One stretch of a planned way, as it was driven before.
struct RouteStep {
  std::int64_t landmark = 0;  ///< where it ends
  double distance_m = 0.0;    ///< expected
  double distance_sigma_m = 0.0;
  double turn_rad = 0.0;   ///< expected turn of the heading from the landmark before to this one
  bool backwards = false;  ///< was driven only the other way round
};

/// A way over landmarks, in fixed memory.
struct RoutePlan {
  static constexpr std::size_t kMost = 64;  ///< by hand: steps, a quarter of all stations
  bool found = false;
  std::array<RouteStep, kMost> steps{};
  std::size_t size = 0;
  double distance_m = 0.0;

  [[nodiscard]] std::span<const RouteStep> all() const { return {steps.data(), size}; }
};

/// The ways from landmark to landmark that were driven, of earlier missions and of this one: a
/// graph whose cost is the expected distance, made longer by doubt and by failures.
class RouteMap {
 public:
  static constexpr std::size_t kStations = 256;  ///< by hand: twice what EkfSlam holds at once
  static constexpr std::size_t kRoutes = 1024;   ///< by hand: four from each station

  RouteMap();

  /// From long-term memory, at the start of a mission.
  void know(std::span<const Route> routes);
  /// A stretch was driven; the same stretch again makes it surer. Ignored where there is no room.
  void driven(std::int64_t from, std::int64_t to, double distance_m, double turn_rad);
  /// A stretch could not be driven to its end. Unknown stretches are not noted.
  void failed(std::int64_t from, std::int64_t to);

  /// The cheapest way (Dijkstra), without allocation. From a landmark to itself: found, no steps.
  [[nodiscard]] RoutePlan path_to(std::int64_t from, std::int64_t to) const;
  /// Whether a known stretch begins or ends there.
  [[nodiscard]] bool has(std::int64_t landmark) const { return station_of(landmark) >= 0; }
  [[nodiscard]] const Route* find(std::int64_t from, std::int64_t to) const;
  [[nodiscard]] std::span<const Route> all() const { return routes_; }
  /// Takes the routes that have changed since they were taken last.
  template <class Sink>
  void take_changed(Sink sink) {
    for (std::size_t k = 0; k < routes_.size(); ++k) {
      if (changed_[k]) sink(routes_[k]);
      changed_[k] = false;
    }
  }

 private:
  [[nodiscard]] int station_of(std::int64_t landmark) const;
  bool add(const Route& route);

  std::vector<Route> routes_;  ///< room for kRoutes
  std::vector<bool> changed_;  ///< since they were taken last
  std::vector<std::int64_t> stations_;
};

}  // namespace striate::memory
