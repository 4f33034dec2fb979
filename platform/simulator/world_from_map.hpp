#pragma once

#include <opencv2/core/mat.hpp>
#include <optional>
#include <string>

#include "striate/platform/simulator/world.hpp"

namespace striate::simulator {

/// A floor from above, to be built.
struct FloorPicture {
  cv::Mat1b stands;     ///< not 0: masonry; row 0 has the smallest y
  cv::Mat1b free;       ///< not 0: known to be floor
  double cell_m = 0.0;  ///< side of a cell
  Point2 origin;        ///< outer corner of cell (0, 0)
};

/// A world made of a picture, and how its places are found again.
struct MapWorld {
  World world;
  bool turned = false;  ///< the picture was taller than wide: its y is the world's x
  Point2 moved;         ///< world = picture (turned by -90 degrees about 0 where so) + this
};

/// Walls from floor to ceiling where the picture has some, lamps above what is free, a start where
/// there is room (or where it is asked for, in the picture's frame), and a goal line before the
/// farthest place that a robot of the Pioneer's size gets to from there. Specks of a few cells are
/// left out. @throws UserError where nothing is free, it is larger than worlds may be, the start
/// has no room, or the picture has more walls than can be built
[[nodiscard]] MapWorld world_from_map(const FloorPicture& picture, const std::string& name,
                                      std::optional<Pose2> start = {});

}  // namespace striate::simulator
