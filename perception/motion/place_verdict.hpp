#pragma once

#include "striate/perception/motion/carried_back.hpp"
#include "striate/perception/motion/motion_settings.hpp"
#include "striate/perception/percept.hpp"

namespace striate::perception {

enum class Verdict {
  unknown,  ///< out of the image, not trusted, or hidden before
  stayed,   ///< was there
  came,     ///< all that is trusted around was farther: the earlier image looked through the place
  went,     ///< all was nearer, by no more than a walk, and what was nearer is there no more
};

/// What two images measured.
struct SeenMaps {
  const DisparityMap& now;
  const DisparityMap& before;
  double seconds;  ///< between them
};

/// What became of `point` (robot frame of now), which the image of now shows.
[[nodiscard]] Verdict judge_point(const SpacePoint& point, const CarriedBack& carried,
                                  const SeenMaps& maps, const MotionSettings& settings);

}  // namespace striate::perception
