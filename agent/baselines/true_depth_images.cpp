#include "striate/agent/baselines/true_depth_images.hpp"

#include <cmath>
#include <stdexcept>

namespace striate::agent {
namespace {

constexpr std::size_t kUnderWay = 16;  // images; an image takes less than two periods

}  // namespace

StereoFrame TrueDepthImages::image(const simulator::SceneState& scene) {
  StereoFrame frame = pictures_.image(scene);
  last_.push_back({frame.left, renderer_.true_depth(scene, width_px_)});
  if (last_.size() > kUnderWay) last_.pop_front();
  return frame;
}

cv::Mat1f TrueDepthImages::depth_of(const cv::Mat3b& left) const {
  for (const DepthOfImage& known : last_) {
    if (known.left.data == left.data) return known.depth_m;  // shared, not copied, on its way
  }
  return {};
}

void TrueDisparity::measure(const StereoFrame& frame, perception::DisparityMap& map) {
  const cv::Mat1f depth_m = pictures_.depth_of(frame.left);
  if (depth_m.empty()) throw std::logic_error("an image without its true depth");
  map.disparity_px.create(depth_m.size());
  map.confidence.create(depth_m.size());
  const double metre_px = map.focal_px * map.baseline_m;
  for (int v = 0; v < depth_m.rows; ++v) {
    for (int u = 0; u < depth_m.cols; ++u) {
      const float depth = depth_m(v, u);
      const bool known = std::isfinite(depth) && depth > 0.0F;
      map.disparity_px(v, u) = known ? static_cast<float>(metre_px / depth) : perception::kNoMatch;
      map.confidence(v, u) = known ? 1.0F : 0.0F;
    }
  }
}

}  // namespace striate::agent
