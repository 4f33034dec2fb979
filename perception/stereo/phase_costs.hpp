#pragma once

#include <cstdint>

#include "striate/perception/descriptor/phase_code.hpp"
#include "striate/perception/stereo/volume.hpp"

namespace striate::perception {

/// Hamming distances of the 256-bit phase descriptors of all pixels at all disparities.
///
/// A descriptor is made of the phase codes of its neighbours, so the distance of two descriptors
/// is the sum of 8 distances of codes at the same disparity, each of which is needed 8 times and
/// computed once. Integer arithmetic; vectorised. Keeps its buffers.
class PhaseCosts {
 public:
  struct Job {
    const PhaseCodes& left;
    const PhaseCodes& right;  ///< with a margin of at least the disparities, in columns
    /// Row 0 is 255 left of column 0 and 0 from there on, for the same margin.
    const Plane<std::uint8_t>& outside;
    /// [row][disparity][column]; of the size of the images and a multiple of 4 disparities. Gets
    /// the bits that differ, at most 255; 255 where the right pixel lies outside the image.
    Volume<std::uint8_t>& costs;
  };
  /// All rows, from the first to the last.
  void compute_row(const Job& job, int y);

 private:
  void compare_codes(const Job& job, int y);

  Volume<std::uint8_t> code_distances_;  ///< a ring of as many lines as a descriptor is high
};

}  // namespace striate::perception
