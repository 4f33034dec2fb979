#pragma once

#include <opencv2/core/mat.hpp>
#include <optional>
#include <vector>

#include "striate/agent/recall/known_things.hpp"

namespace striate::app {

/// A thing, and how far it is where stereo tells.
struct PlacedThing {
  agent::KnownThing thing;
  std::optional<double> range_m;      ///< from the left camera, along its axis
  std::optional<double> bearing_deg;  ///< of its middle, to the left positive
};

/// The picture with a frame around each thing and its name. Throws nothing for any places.
[[nodiscard]] cv::Mat3b draw_recognised(const cv::Mat3b& picture,
                                        const std::vector<PlacedThing>& things);

}  // namespace striate::app
