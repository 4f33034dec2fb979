#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "striate/memory/localisation/localisation_settings.hpp"
#include "striate/memory/localisation/obstacle_grid.hpp"
#include "striate/memory/localisation/route_learner.hpp"
#include "striate/memory/localisation/route_map.hpp"
#include "striate/memory/localisation/slam_estimate.hpp"
#include "striate/memory/long_term/records.hpp"
#include "striate/memory/short_term/landmark_memory.hpp"
#include "striate/memory/short_term/local_grid.hpp"

namespace striate::memory {

/// What long-term memory knows of places when a mission starts.
struct MapKnowledge {
  std::vector<Landmark> landmarks;  ///< those that can be recognised, with a position or without
  std::vector<Route> routes;
  std::vector<ObstacleCell> cells;
};

/// What is new about places, for the long-term memory to keep.
struct MapNews {
  struct Position {
    std::int64_t landmark = 0;
    MapPosition at;
  };
  std::vector<Position> positions;
  std::vector<Route> routes;
  std::vector<ObstacleCell> cells;

  [[nodiscard]] bool empty() const { return positions.empty() && routes.empty() && cells.empty(); }
};

/// Where the robot is on the map of its memory, and what it learns of the map: landmarks' places,
/// routes, obstacles. Does nothing until it is handed what is known. Two frames: the *odometry*
/// frame of this run, in which everything else in short-term memory lives, and the *map*, which
/// stays the same over missions. Allocates when knowledge and news are handed over, never between.
class Localisation {
 public:
  explicit Localisation(const LocalisationSettings& settings);

  /// Once, before the first step. An empty memory starts a map with its origin at the first pose.
  void know(const MapKnowledge& knowledge);
  [[nodiscard]] bool active() const { return active_; }

  /// Once a cycle: the robot's pose, odometry frame.
  void move(const Pose2& odometry);
  /// A confirmed sighting; `at` is the robot's pose at the image's moment, odometry frame.
  SightingVerdict see(const LandmarkSighting& sighting, const Pose2& at);
  /// The window of short-term memory is about to move to `next`: what leaves it goes on the map.
  void keep_leaving(const LocalGrid& grid, Point2 next);
  /// All that the window holds, at the end of a mission.
  void keep_all(const LocalGrid& grid);
  /// The mission failed under way: the stretch towards what lies ahead is noted as failed.
  void fail();

  /// Places that have become known or better, into short-term memory.
  void recall_into(LandmarkMemory& landmarks);

  /// Whether it is known where on the map this run is.
  [[nodiscard]] bool located() const { return active_ && estimate_.located(); }
  [[nodiscard]] const SlamEstimate& estimate() const { return estimate_; }
  [[nodiscard]] const RouteMap& routes() const { return routes_; }
  [[nodiscard]] const ObstacleGrid& obstacles() const { return obstacles_; }
  /// Where this run started, corrected, in the odometry frame: goal of a return to the start.
  [[nodiscard]] Pose2 start() const;
  /// The landmark passed last, or else the nearest with a place; 0: none.
  [[nodiscard]] std::int64_t last_station() const;
  /// From the last station to a landmark, over what was driven before.
  [[nodiscard]] RoutePlan path_to(std::int64_t landmark) const;
  /// From the last station to the landmark nearest to where this run started.
  [[nodiscard]] RoutePlan path_home() const;

  /// What is new since the last call. @param operating_s stamp of the obstacle cells
  [[nodiscard]] MapNews take_news(double operating_s);

 private:
  struct Name {
    std::int64_t landmark = 0;
    std::string name;
  };
  void pass(const Station& station);
  [[nodiscard]] std::int64_t nearest_station(const Pose2& to) const;
  void keep(const LocalGrid& grid, GridCell first, GridCell beyond);

  bool active_ = false;
  bool started_ = false;
  SlamEstimate estimate_;
  RouteMap routes_;
  RouteLearner learner_;
  ObstacleGrid obstacles_;
  std::vector<Name> names_;  ///< as the estimate's landmarks
  Station last_;             ///< passed; landmark 0: none yet
  std::vector<Station> passed_now_;
  struct Near {
    double distance2_m2 = 0.0;
    std::size_t landmark = 0;  ///< its place among the estimate's
  };
  std::vector<Near> near_;
};

}  // namespace striate::memory
