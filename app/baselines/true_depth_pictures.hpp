#pragma once

#include <deque>

#include "app/renderer_pictures.hpp"
#include "perception/stereo/disparity_source.hpp"

namespace striate {

/// The renderer's pictures, each with its true depth for as long as the picture may be under way.
class TrueDepthPictures final : public simulator::PictureSource {
 public:
  /// `width_px`: of the depth.
  TrueDepthPictures(simulator::PictureSource& pictures, simulator::Renderer& renderer, int width_px)
      : pictures_(pictures), renderer_(renderer), width_px_(width_px) {}
  StereoFrame picture(const simulator::SceneState& scene) override;
  [[nodiscard]] double light_level(Point2 place) const override {
    return pictures_.light_level(place);
  }

  /// Depth in metres of this very picture; empty if it is not one of the last.
  [[nodiscard]] cv::Mat1f depth_of(const cv::Mat3b& left) const;

 private:
  struct Known {
    cv::Mat3b left;
    cv::Mat1f depth_m;
  };
  simulator::PictureSource& pictures_;
  simulator::Renderer& renderer_;
  int width_px_;
  std::deque<Known> last_;
};

/// The true disparity of each pixel, all of it sure; unknown where nothing is.
class TrueDisparity final : public DisparitySource {
 public:
  explicit TrueDisparity(const TrueDepthPictures& pictures) : pictures_(pictures) {}
  void measure(const StereoFrame& frame, DisparityMap& map) override;

 private:
  const TrueDepthPictures& pictures_;
};

}  // namespace striate
