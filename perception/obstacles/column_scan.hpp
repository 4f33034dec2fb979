#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "striate/perception/obstacles/obstacle_settings.hpp"
#include "striate/perception/obstacles/view_geometry.hpp"

namespace striate::perception {

/// What a pixel is, seen against the floor line.
enum class PixelKind : unsigned char {
  unknown,   ///< no trusted disparity
  floor,     ///< on the floor line
  beneath,   ///< farther than the floor: a mirror image in it, so nothing stands there
  standing,  ///< between the lowest and the highest height that matter
  overhead,  ///< higher
};

/// A disparity map with every pixel judged against the floor.
struct JudgedMap {
  cv::Mat1b kind;    ///< PixelKind
  cv::Mat1f weight;  ///< how much the pixel counts as what it is, 0..1
  cv::Mat1f level;   ///< level disparity of standing pixels, px; elsewhere undefined
};

/// The nearest thing that stands in a column.
struct Standing {
  double level_px = 0.0;  ///< level disparity; 0: nothing found
  double row_px = 0.0;    ///< mean row of the pixels that show it
  double support = 0.0;   ///< weight found over weight needed; >= 1 where found
  int top_row = 0;        ///< highest row that shows it
  int bottom_row = 0;     ///< lowest row that shows it
  bool bridged = false;   ///< not seen itself: lies in the plane of what is seen on both sides
};

/// `floor_offset_px` is added to the floor line.
[[nodiscard]] JudgedMap judge_pixels(const DisparityMap& map, const ViewGeometry& geometry,
                                     const ObstacleSettings& settings, double floor_offset_px);

/// Per column the nearest level disparity on which enough weight agrees.
[[nodiscard]] std::vector<Standing> find_standing(const JudgedMap& judged,
                                                  const ViewGeometry& geometry,
                                                  const ObstacleSettings& settings);

/// Fills unknown columns between two that lie on one upright plane, where nothing farther is seen
/// in them. An upright plane has level disparities linear in u, so the bridge is exact for walls.
void bridge_unknown_columns(std::vector<Standing>& standing, const JudgedMap& judged,
                            const ObstacleSettings& settings);

}  // namespace striate::perception
