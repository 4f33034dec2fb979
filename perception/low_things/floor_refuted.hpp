#pragma once

#include "striate/perception/low_things/floor_band.hpp"
#include "striate/perception/percept.hpp"

namespace striate::perception {

/// How much better a pixel's own disparity explains its neighbourhood than the floor does: the mean
/// square of what is left between the two eyes on the floor, over that at the pixel's disparity. 1
/// where the disparity is the floor's, or there is none. Where the floor is plain, shines or is
/// dark its disparities err by a pixel and more; then both explain as much.
/// @param moved of the band's size, disparities as the band has them. @param floor_px the floor's
[[nodiscard]] cv::Mat1f floor_refuted_by(const FloorBand& band, const cv::Mat1f& moved,
                                         double floor_px);

}  // namespace striate::perception
