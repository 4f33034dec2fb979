#pragma once

#include "striate/memory/short_term/short_term_memory.hpp"
#include "striate/platform/interface/robot.hpp"

namespace striate::behaviours {

/// Nearer to where known floor ends no behaviour backs by itself. By hand: two patches of the map;
/// at 0.12 m/s the robot stops within 0.06 m.
inline constexpr double kRoomBehind_m = 0.10;

/// How far straight back from the rear end the floor is known free, all across the robot: seen
/// free, or driven over a short while ago. No eye looks back while the robot backs, so what is not
/// known there may be a wall or a person. Metres, 0 .. 1, in steps of a patch.
[[nodiscard]] double free_behind_m(const memory::ShortTermMemory& memory,
                                   const RobotDescription& robot);

}  // namespace striate::behaviours
