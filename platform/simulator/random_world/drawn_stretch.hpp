#pragma once

#include <cstddef>
#include <string>

namespace striate::simulator {

/// A stretch of a drawn building and what makes it what it is.
struct DrawnStretch {
  double from_m = 0.0;
  double to_m = 0.0;
  std::string story;               ///< "a parcel 12 cm high lies in the lane"
  std::size_t first_obstacle = 0;  ///< its obstacles in `World::obstacles`
  std::size_t end_obstacle = 0;
};

}  // namespace striate::simulator
