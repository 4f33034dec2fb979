#pragma once

#include <string>
#include <vector>

#include "striate/memory/long_term/records.hpp"

namespace striate::agent::pictures {

/// The map from above as SVG text: the same as `draw_memory_map` shows, in lines that can be
/// enlarged. @throws UserError where there is nothing to draw
[[nodiscard]] std::string memory_map_svg(const std::vector<memory::Landmark>& landmarks,
                                         const std::vector<memory::Route>& routes,
                                         const std::vector<memory::ObstacleCell>& cells);

}  // namespace striate::agent::pictures
