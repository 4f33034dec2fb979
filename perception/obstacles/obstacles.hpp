#pragma once

#include <vector>

#include "striate/perception/obstacles/obstacle_settings.hpp"
#include "striate/perception/percept.hpp"
#include "striate/platform/interface/robot.hpp"
#include "striate/platform/interface/senses.hpp"

namespace striate::perception {

/// What one disparity map says about the floor plan in front.
struct ObstacleView {
  std::vector<Column> columns;      ///< one per column of the map, left to right
  std::vector<Obstacle> obstacles;  ///< nearest first
  double floor_offset_px = 0.0;     ///< correction of the floor line that this image asked for
};

/// The robust way: the floor line separates floor from what stands on it, a column is blocked by
/// the nearest disparity that enough trusted pixels of it and of its neighbours agree on, and the
/// floor is free only where it was seen as floor. Empty for an empty map; throws nothing.
[[nodiscard]] ObstacleView find_obstacles(const DisparityMap& map, const HeadPose& head,
                                          const RobotDescription& robot,
                                          const ObstacleSettings& settings);

/// The paper's way: threshold on disparity, binary obstacle map, blobs. All that is no blob counts
/// as free up to the distance of the threshold. Two deviations: the threshold follows the
/// floor line where the head looks down (the paper's camera never saw the near floor), and the
/// distance is measured on the floor plan, not along the optical axis.
[[nodiscard]] ObstacleView find_obstacles_as_in_paper(const DisparityMap& map, const HeadPose& head,
                                                      const RobotDescription& robot,
                                                      const ObstacleSettings& settings);

}  // namespace striate::perception
