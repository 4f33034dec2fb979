#pragma once

#include "striate/perception/percept.hpp"

namespace striate::perception {

/// What is known of a place on the floor. Unknown is never free, and hidden is not unknown for want
/// of texture or light: another place to look from would show it.
enum class FloorState { free, occupied, unknown, hidden };

/// What `column` says of the floor `range_m` from the axle along its bearing. The nearest obstacle
/// occupies the 0.1 m from its front; its depth is not seen.
[[nodiscard]] FloorState floor_state(const Column& column, double range_m);

/// Notes on `column` that its obstacle hides the floor up to `to_m` (kNothing_m: to no end), or
/// nothing where it has none.
void hide_behind_obstacle(Column& column, double to_m);

}  // namespace striate::perception
