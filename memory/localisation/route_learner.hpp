#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "striate/memory/localisation/slam_estimate.hpp"

namespace striate::memory {

/// Where a landmark was passed: at the point of the way that was nearest to it.
struct Station {
  std::int64_t landmark = 0;
  double way_m = 0.0;        ///< odometry's way, all ways forward and back
  double heading_rad = 0.0;  ///< odometry frame
};

/// Finds out which landmarks are passed, and where. A landmark counts that was seen not long before
/// and comes near; it is passed when it gets farther away again.
class RouteLearner {
 public:
  explicit RouteLearner(const LocalisationSettings& settings) : settings_(settings) {}

  /// Room for so many landmarks.
  void start(std::size_t landmarks) { nearest_.assign(landmarks, {}); }
  /// Once a cycle. @param passed gets the stations that are complete now, oldest first
  void move(const SlamEstimate& estimate, std::vector<Station>& passed);

 private:
  static constexpr double kNone = std::numeric_limits<double>::infinity();
  struct Nearest {
    bool approached = false;
    double distance_m = 0.0;
    double way_m = 0.0;
    double heading_rad = 0.0;
    double left_at_m = -1e9;    ///< way when it was passed last
    double farthest_m = kNone;  ///< distance since then
  };
  LocalisationSettings settings_;
  std::vector<Nearest> nearest_;
};

}  // namespace striate::memory
