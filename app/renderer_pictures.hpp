#pragma once

#include <cstdint>

#include "platform/simulator/picture_source.hpp"
#include "platform/simulator/render/renderer.hpp"

namespace striate {

/// The renderer as the simulated Pioneer's eyes.
class RendererPictures final : public simulator::PictureSource {
 public:
  RendererPictures(const simulator::World& world, const simulator::FloorPlan& plan,
                   const simulator::CameraSettings& camera, std::uint64_t seed)
      : renderer_(world, plan, camera, seed) {}
  StereoFrame picture(const simulator::SceneState& scene) override {
    return renderer_.picture(scene);
  }
  [[nodiscard]] double light_level(Point2 place) const override {
    return renderer_.light_level(place);
  }
  [[nodiscard]] simulator::Renderer& renderer() { return renderer_; }

 private:
  simulator::Renderer renderer_;
};

}  // namespace striate
