#include "striate/perception/recognition/region_depth.hpp"

#include <algorithm>
#include <cmath>

#include "striate/base/index_within.hpp"

namespace striate::perception {

double median_disparity_px(const DisparityMap& map, const cv::Rect2d& box,
                           std::vector<float>& buffer) {
  const cv::Mat1f& disparity = map.disparity_px;
  const int left = round_within(box.x, 0, disparity.cols);
  const int top = round_within(box.y, 0, disparity.rows);
  const int right = round_within(box.x + box.width, -1, disparity.cols - 1) + 1;
  const int bottom = round_within(box.y + box.height, -1, disparity.rows - 1) + 1;
  if (left >= right || top >= bottom) return 0.0;
  buffer.clear();
  for (int v = top; v < bottom; ++v) {
    for (int u = left; u < right; ++u) {
      const float d = disparity(v, u);
      if (std::isfinite(d) && d > 0.0F) buffer.push_back(d);
    }
  }
  const auto area = static_cast<std::size_t>((right - left) * (bottom - top));
  if (buffer.empty() || buffer.size() * 10 < area) return 0.0;
  const auto middle = buffer.begin() + static_cast<std::ptrdiff_t>(buffer.size() / 2);
  std::nth_element(buffer.begin(), middle, buffer.end());
  return *middle;
}

}  // namespace striate::perception
