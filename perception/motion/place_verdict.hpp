#pragma once

#include "perception/motion/carried_back.hpp"
#include "perception/motion/motion_settings.hpp"
#include "perception/percept.hpp"

namespace striate {

enum class Verdict {
  unknown,  ///< out of the picture, not trusted, or hidden before
  stayed,   ///< was there
  came,  ///< all that is trusted around was farther: the earlier picture looked through the place
  went,  ///< all was nearer, by no more than a walk, and what was nearer is there no more
};

/// What two pictures measured.
struct SeenMaps {
  const DisparityMap& now;
  const DisparityMap& before;
  double seconds;  ///< between them
};

/// What became of `point` (robot frame of now), which the picture of now shows.
[[nodiscard]] Verdict judge_point(const SpacePoint& point, const CarriedBack& carried,
                                  const SeenMaps& maps, const MotionSettings& settings);

}  // namespace striate
