#pragma once

#include <string>

#include "striate/platform/datasets/calibration/camera_model.hpp"

namespace striate::datasets {

/// Looks at what a calibration says before anything is counted with it: focal lengths, principal
/// points, rotations (nearly orthonormal ones are made so), the eyes' order and distance, its unit.
/// What is certain is put right and said in the remarks: a length in mm, the right eye named first.
/// @param names of its files. @throws UserError for what cannot be, or can be meant in two ways
void judge_model(StereoModel& model, const std::string& names);

/// The same two cameras with the second one first.
void exchange_eyes(StereoModel& model);

}  // namespace striate::datasets
