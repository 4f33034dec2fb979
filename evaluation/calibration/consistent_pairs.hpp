#pragma once

#include <cstddef>
#include <vector>

#include "striate/evaluation/calibration/chessboard.hpp"
#include "striate/platform/pioneer/camera/stereo_calibration.hpp"

namespace striate::evaluation {

/// Which looks at a board can be of one stereo camera. A right image that was taken a moment after
/// the left one, or belongs to another pair, shows the board elsewhere; one such pair among twelve
/// spoils the calibration, and spreads its error over all of them. The eyes are fixed to each
/// other: each pair alone tells how, from the board's pose in either image, and those that tell the
/// same are kept.
/// @param lenses of both eyes, each calibrated alone; their pose to each other is not looked at
/// @param blur_px how far the corners of a usual look are from where the lens alone puts them: what
/// is seen badly agrees less well
/// @return indices of the pairs, in their order: the largest set that agrees
[[nodiscard]] std::vector<std::size_t> consistent_pairs(const std::vector<BoardPair>& pairs,
                                                        const Chessboard& board,
                                                        const pioneer::StereoCalibration& lenses,
                                                        double blur_px);

/// How far the corners in the right image are from where the board in the left image and the
/// calibration put them: root mean square, px.
[[nodiscard]] double disagreement_px(const BoardPair& pair, const Chessboard& board,
                                     const pioneer::StereoCalibration& calibration);

}  // namespace striate::evaluation
