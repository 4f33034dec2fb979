#pragma once

#include <cstdint>
#include <filesystem>
#include <opencv2/core/mat.hpp>

#include "striate/base/geometry.hpp"

namespace striate::datasets {

/// What a cell of a map of others says.
enum class MapCell : std::uint8_t { free, unknown, stands };

/// A floor from above, as ROS's map_server and Nav2 write it.
struct OccupancyMap {
  cv::Mat1b cells;      ///< of MapCell; row 0 has the smallest y, column 0 the smallest x
  double cell_m = 0.0;  ///< side of a cell
  Point2 origin;        ///< outer corner of cell (0, 0), in the map's frame
};

/// Reads FILE.yaml and the picture that it names. Pictures are 16 to some thousand cells a side.
/// @throws UserError with file:line:column for what is no such map, and for one that is turned
/// (origin's third number)
[[nodiscard]] OccupancyMap read_map(const std::filesystem::path& file);

}  // namespace striate::datasets
