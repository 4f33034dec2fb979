#pragma once

#include "striate/perception/low_things/floor_band.hpp"

namespace striate::perception {

/// How much better a pixel's own disparity explains its neighbourhood than the floor does. Where
/// the floor is plain, shines or is dark its disparities err by a pixel and more; then both explain
/// as much.
class FloorRefutation {
 public:
  /// @param floor_px the floor's disparity, as the band has them
  FloorRefutation(const FloorBand& band, double floor_px);

  /// The mean square of what is left between the two eyes on the floor, over that at `disparity_px`
  /// (as the band has them, finite); about 1 where both explain as much.
  [[nodiscard]] float at(int row, int column, float disparity_px) const;

 private:
  [[nodiscard]] float left_over(int row, int column, int shift_px) const;

  cv::Mat1f left_;  ///< without the mean of each patch
  cv::Mat1f right_;
  int floor_px_;
};

}  // namespace striate::perception
