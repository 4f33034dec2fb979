#pragma once

#include "striate/perception/percept.hpp"
#include "striate/platform/interface/senses.hpp"

namespace striate::perception {

/// Disparities from elsewhere than Striate's own stereo: what perception, memory and behaviours
/// make of them can be compared. Perception knows none; a trial brings it.
class DisparitySource {
 public:
  virtual ~DisparitySource() = default;

  /// Fills `disparity_px` and `confidence` at the working size. The camera in `map` is that of the
  /// working size already. Throws what its stereo throws.
  virtual void measure(const StereoFrame& frame, DisparityMap& map) = 0;
};

}  // namespace striate::perception
