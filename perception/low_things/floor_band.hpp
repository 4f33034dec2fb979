#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "striate/perception/obstacles/view_geometry.hpp"

namespace striate::perception {

/// The part of an image pair that shows the near floor, cut out of both images, and the right one
/// moved to the right row by row so that the floor has the same small disparity in every row. To
/// the matcher the slanted floor is then what a wall straight ahead is otherwise: one disparity,
/// and few to be searched.
struct FloorBand {
  int first_row = 0;             ///< of the images that it was cut from
  cv::Mat1w left, right;         ///< sixteenths of a grey level; empty: no near floor in view
  std::vector<double> moved_px;  ///< each row of the right image, to the right; may be negative
};

/// @param left, right of to_fine_working_size. @param geometry of a map of their size.
/// @param first_row from here on to the bottom. @param floor_px disparity that the floor gets
[[nodiscard]] FloorBand cut_floor_band(const cv::Mat1w& left, const cv::Mat1w& right,
                                       const ViewGeometry& geometry, int first_row,
                                       double floor_px);

/// Moves a row by `sixteenths` of a pixel to the right (cubic, Catmull and Rom 1974); what comes in
/// is the nearest pixel of the row. Integer arithmetic. @param from, to `width` values up to 4080
void move_row(const std::uint16_t* from, int width, int sixteenths, std::uint16_t* to);

}  // namespace striate::perception
