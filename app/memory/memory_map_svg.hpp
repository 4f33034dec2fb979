#pragma once

#include <string>
#include <vector>

#include "memory/long_term/records.hpp"

namespace striate::pictures {

/// The map from above as SVG text: the same as `draw_memory_map` shows, in lines that can be
/// enlarged. @throws UserError where there is nothing to draw
[[nodiscard]] std::string memory_map_svg(const std::vector<Landmark>& landmarks,
                                         const std::vector<Route>& routes,
                                         const std::vector<ObstacleCell>& cells);

}  // namespace striate::pictures
