#pragma once

#include <vector>

#include "striate/perception/obstacles/view_geometry.hpp"
#include "striate/perception/percept.hpp"

namespace striate::perception {

/// Blank walls: where a column shows nothing that stands, or only something behind the corridor's
/// wall, and not many trusted pixels of it look through that wall, the wall is put in as obstacle
/// with little confidence, and the free floor ends there. Open doors and side corridors stay open,
/// for there stereo does see through.
void complete_with_walls(std::vector<Column>& columns, const CorridorView& corridor,
                         const DisparityMap& map, const ViewGeometry& geometry);

}  // namespace striate::perception
