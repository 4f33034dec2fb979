#pragma once

#include <string>

#include "striate/platform/simulator/scene.hpp"
#include "striate/platform/simulator/shapes.hpp"
#include "striate/platform/simulator/world.hpp"

namespace striate::simulator {

/// What somebody who is put into the world would stand in. Things that come later are not asked.
/// @param body in the plan
/// @return "a wall", "table_1", "a person"; empty: nothing
[[nodiscard]] std::string overlapped_by(const World& world, const FloorPlan& plan,
                                        const ConvexShape& body);

/// Whether somebody can be put there: within the walls, and nothing is in the way at first.
/// @param what the place is, for the message: "--at"
/// @param along corridor coordinates
/// @param body around its own middle, heading along x
/// @throws UserError saying what is wrong with the place
void check_place(const World& world, const std::string& what, const Pose2& along,
                 const ConvexShape& body);

}  // namespace striate::simulator
