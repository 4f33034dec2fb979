#pragma once

#include <vector>

#include "striate/perception/obstacles/column_scan.hpp"

namespace striate::perception {

/// The stretch of floor that a column shows to be free; empty if `to_row` >= `from_row`.
struct FreeFloor {
  int from_row = -1;        ///< lowest row of it (nearest to the robot)
  int to_row = -1;          ///< highest row of it
  double confidence = 0.0;  ///< mean weight of the floor seen on the way
};

/// Follows the floor of every column upwards from the bottom of the image until something
/// stands there or nothing is known for longer than the settings bridge.
[[nodiscard]] std::vector<FreeFloor> find_free_floor(const JudgedMap& judged,
                                                     const ViewGeometry& geometry,
                                                     const ObstacleSettings& settings);

/// The offset of the floor line that this image asks for: the median over trusted pixels near
/// the floor line, 0 where too few show it, never more than the settings allow. It takes up small
/// errors of tilt and rectification, both of which shift the line as a whole.
[[nodiscard]] double calibrate_floor(const DisparityMap& map, const ViewGeometry& geometry,
                                     const ObstacleSettings& settings);

}  // namespace striate::perception
