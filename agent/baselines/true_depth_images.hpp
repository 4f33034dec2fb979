#pragma once

#include <deque>

#include "striate/perception/stereo/disparity_source.hpp"
#include "striate/platform/simulator/render/renderer_images.hpp"

namespace striate::agent {

/// The renderer's images, each with its true depth for as long as the image may be under way.
class TrueDepthImages final : public simulator::ImageSource {
 public:
  /// `width_px`: of the depth.
  TrueDepthImages(simulator::ImageSource& pictures, simulator::Renderer& renderer, int width_px)
      : pictures_(pictures), renderer_(renderer), width_px_(width_px) {}
  StereoFrame image(const simulator::SceneState& scene) override;
  [[nodiscard]] double light_level(Point2 place) const override {
    return pictures_.light_level(place);
  }

  /// Depth in metres of this very image; empty if it is not one of the last.
  [[nodiscard]] cv::Mat1f depth_of(const cv::Mat3b& left) const;

 private:
  struct DepthOfImage {
    cv::Mat3b left;
    cv::Mat1f depth_m;
  };
  simulator::ImageSource& pictures_;
  simulator::Renderer& renderer_;
  int width_px_;
  std::deque<DepthOfImage> last_;
};

/// The true disparity of each pixel, all of it sure; unknown where nothing is.
class TrueDisparity final : public perception::DisparitySource {
 public:
  explicit TrueDisparity(const TrueDepthImages& pictures) : pictures_(pictures) {}
  void measure(const StereoFrame& frame, perception::DisparityMap& map) override;

 private:
  const TrueDepthImages& pictures_;
};

}  // namespace striate::agent
