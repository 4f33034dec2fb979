#pragma once

#include "striate/platform/interface/senses.hpp"

namespace striate {

/// The right eye of a rectified pair as its calibration has it. What is far away lies at the
/// principal point's column plus the same way in either eye, so that its disparity is the left
/// principal point less the right one, which many calibrations leave other than zero: Middlebury's
/// `doffs`, the P matrices of ROS, any pair rectified without CALIB_ZERO_DISPARITY.
struct RightEye {
  double focal_px = 0.0;  ///< 0: as long as the left one
  double centre_u_px = 0.0;
  double centre_v_px = 0.0;
};

/// Moves the right image to where an eye with the left one's principal point (and focal length)
/// would have seen it: from then on Z = f b / d holds for the pair, which everything behind it
/// counts on, and what is far away has a disparity of zero instead of one below it. Columns that
/// come from beyond the image repeat its edge, where nothing can be matched. Nothing is done where
/// the two agree within a hundredth of a pixel at every edge, or there is no right image.
/// @throws std::runtime_error where the two cannot be eyes of one rectified pair
void align_eyes(StereoFrame& frame, const RightEye& right);

}  // namespace striate
