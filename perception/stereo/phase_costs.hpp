#pragma once

#include <cstdint>

#include "perception/descriptor/phase_code.hpp"
#include "perception/stereo/volume.hpp"

namespace striate {

/// Hamming distances of the 256-bit phase descriptors of all pixels at all disparities.
///
/// A descriptor is made of the phase codes of its neighbours, so the distance of two descriptors
/// is the sum of 8 distances of codes at the same disparity, each of which is needed 8 times and
/// computed once. Integer arithmetic; vectorised. Keeps its buffers.
class PhaseCosts {
 public:
  /// @param right with a margin of at least `disparities` columns.
  /// @param outside row 0 is 255 left of column 0 and 0 from there on, for the same margin.
  /// @param disparities a multiple of 4.
  /// @param costs [row][disparity][column]: bits that differ, at most 255; 255 where the right
  /// pixel lies outside the picture.
  void compute(const PhaseCodes& left, const PhaseCodes& right, const Plane<std::uint8_t>& outside,
               int disparities, Volume<std::uint8_t>& costs);

 private:
  Volume<std::uint8_t> code_distances_;  ///< a ring of as many lines as a descriptor is high
};

}  // namespace striate
