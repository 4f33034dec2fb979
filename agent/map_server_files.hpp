#pragma once

#include <string>
#include <vector>

#include "striate/memory/long_term/records.hpp"

namespace striate::agent {

/// A map as the two files that ROS's map_server, Nav2 and many planners read.
struct MapServerFiles {
  std::string yaml;
  std::string pgm;  ///< binary, a pixel a cell: 0 stands, 254 free, 205 unknown; the top row has
                    ///< the largest y
};

/// @param image how the YAML calls the picture that lies beside it
/// @throws UserError where no cell is known, or they lie too far apart for one picture
[[nodiscard]] MapServerFiles map_server_files(const std::vector<memory::ObstacleCell>& cells,
                                              const std::string& image);

}  // namespace striate::agent
