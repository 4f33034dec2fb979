#pragma once

#include <opencv2/core/mat.hpp>
#include <string>

#include "striate/platform/simulator/judge.hpp"
#include "striate/platform/simulator/scene.hpp"

namespace striate::agent::pictures {

/// A run from above: walls, obstacles with their names, how light the floor is, the driven way
/// coloured by speed, the ways of the people, near misses (rings) and collisions (crosses). A
/// straight corridor is cut into strips that lie below each other.
/// @param light nullptr where nothing is known of the light.
[[nodiscard]] cv::Mat3b draw_plan(const simulator::World& world, const simulator::FloorPlan& plan,
                                  const simulator::Judge& judge,
                                  const simulator::ImageSource* light, const std::string& title);

}  // namespace striate::agent::pictures
