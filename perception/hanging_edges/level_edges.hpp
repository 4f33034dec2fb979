#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

namespace striate::perception {

/// An edge that runs nearly level through an image, without a break.
struct LevelEdge {
  int from_u_px = 0;  ///< columns, both inclusive
  int to_u_px = 0;
  std::vector<float> row_px;  ///< of each column, sub-pixel
  bool brightens = false;     ///< downwards
  bool cut_left = false;      ///< it goes on beyond the image's border: its end is not seen
  bool cut_right = false;

  [[nodiscard]] int length_px() const { return to_u_px - from_u_px + 1; }
  [[nodiscard]] float row_at(int u_px) const {
    return row_px[static_cast<std::size_t>(u_px - from_u_px)];
  }
  [[nodiscard]] float middle_row_px() const { return row_px[row_px.size() / 2]; }
};

/// Edges of at least `shortest_px` columns between the two rows. Level ones alone: their change
/// across the rows is much larger than that along them.
[[nodiscard]] std::vector<LevelEdge> find_level_edges(const cv::Mat1b& grey, cv::Range rows,
                                                      int shortest_px);

}  // namespace striate::perception
