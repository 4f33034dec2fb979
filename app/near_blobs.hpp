#pragma once

#include "striate/app/perceive_frame.hpp"

/// What is near, found without a floor: by disparity alone.
namespace striate::app {

/// Obstacles of a camera whose height above the floor nobody knows: the paper's near blobs.
void find_near_blobs(const PerceiveOptions& o, const StereoFrame& frame, JudgedFrame& judged);

}  // namespace striate::app
