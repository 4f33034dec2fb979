#pragma once

#include "striate/app/judged_frame.hpp"
#include "striate/app/perceive_options.hpp"
#include "striate/platform/interface/senses.hpp"

/// What is near, found without a floor: by disparity alone.
namespace striate::app {

/// Obstacles of a camera whose height above the floor nobody knows: the paper's near blobs.
void find_near_blobs(const PerceiveOptions& o, const StereoFrame& frame, JudgedFrame& judged);

}  // namespace striate::app
