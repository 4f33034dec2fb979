#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

namespace striate::perception {

/// A point on an edge: sub-pixel position, unit normal along the gradient, and how far its gradient
/// stands above the image's noise, 0..1.
struct EdgePoint {
  float u_px = 0.0F;
  float v_px = 0.0F;
  float normal_u = 0.0F;
  float normal_v = 0.0F;
  float weight = 0.0F;
};

/// Ridges of the gradient magnitude (Canny's first steps), the orientation from the structure
/// tensor over 3x3 pixels. The threshold follows the image's own median gradient, so that noise
/// in the dark gives few points and not a carpet.
[[nodiscard]] std::vector<EdgePoint> find_edge_points(const cv::Mat1b& grey);

}  // namespace striate::perception
