#pragma once

#include <vector>

#include "striate/perception/hanging_edges/hanging_edge_settings.hpp"
#include "striate/perception/hanging_edges/level_edges.hpp"
#include "striate/perception/obstacles/obstacles.hpp"
#include "striate/perception/obstacles/view_geometry.hpp"

namespace striate::perception {

/// A level edge that both eyes see, and where it hangs.
struct HangingEdge {
  LevelEdge edge;             ///< in the left image
  double disparity_px = 0.0;  ///< of its left end, or of its right one where the left is not seen
  int at_u_px = 0;            ///< that end's column
  bool both_ends = false;     ///< they agree on it
  double height_m = 0.0;      ///< above the floor
  double distance_m = 0.0;    ///< of that end, from the axle
};

/// What runs along the rows of both eyes looks the same at every disparity; only where it ends is
/// one to be had. All along a straight level edge the disparity is then that of its end, in
/// proportion to how far below the horizon it is.
/// @param left, right grey, rectified, of one size. @param geometry of a map of that size
[[nodiscard]] std::vector<HangingEdge> find_hanging_edges(const cv::Mat1b& left,
                                                          const cv::Mat1b& right,
                                                          const ViewGeometry& geometry,
                                                          const HangingEdgeSettings& settings);

/// Puts the edges into the columns and obstacles of a view where they hang nearer than what was
/// seen there, unless stereo sees through them.
/// @param scale columns of the edges' image for one of the view's
void add_hanging_edges(const std::vector<HangingEdge>& edges, const DisparityMap& map,
                       const ViewGeometry& geometry, int scale, ObstacleView& view);

}  // namespace striate::perception
