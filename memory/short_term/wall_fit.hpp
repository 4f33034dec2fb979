#pragma once

#include <vector>

#include "striate/memory/short_term/local_grid.hpp"

namespace striate::memory {

/// Two parallel walls found in the map.
struct WallFit {
  bool valid = false;
  double heading_rad = 0.0;  ///< of the walls, in the odometry frame
  bool left = false;         ///< whether the wall on that side was found
  bool right = false;
  double left_m = 0.0;  ///< distance of the left wall from the robot, along the walls' normal
  double right_m = 0.0;
};

/// Finds the corridor's walls in what the map remembers: a Hough search over headings within 9
/// degrees of `expected_rad`, because the corridor is the only compass against the drift of the
/// odometry and an image sees both walls seldom. A wall is at least 1.5 m of occupied cells in
/// line; things that move do not count. Deterministic.
class WallFitter {
 public:
  WallFitter();
  [[nodiscard]] WallFit fit(const LocalGrid& grid, const Pose2& robot, double expected_rad);

  /// The same from the edges of the floor that was seen free: where a wall is too plain to match,
  /// the floor ends at it all the same. Both edges must be found, as far apart as `width_m`.
  [[nodiscard]] WallFit fit_edges(const LocalGrid& grid, const Pose2& robot, double expected_rad,
                                  double width_m);

 private:
  struct Line {
    double score = 0.0;
    double distance_m = 0.0;
    bool found = false;
  };
  enum class From : std::uint8_t { things, edges };
  void gather(From from, const LocalGrid& grid, const Pose2& robot, double expected_rad);
  [[nodiscard]] WallFit fit_gathered(double expected_rad) const;
  [[nodiscard]] Line strongest(double turn_rad, double side) const;

  std::vector<Point2> standing_;  // in the frame of the robot's place and the expected heading
};

}  // namespace striate::memory
