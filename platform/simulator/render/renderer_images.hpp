#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "striate/platform/simulator/image_source.hpp"
#include "striate/platform/simulator/late_obstacles.hpp"
#include "striate/platform/simulator/render/renderer.hpp"

namespace striate::simulator {

/// The renderer as the simulated Pioneer's eyes. When an obstacle is put down during the run the
/// world is built and lit anew with it, which takes a second and shows at once.
class RendererImages final : public simulator::ImageSource {
 public:
  RendererImages(const simulator::World& world, const simulator::FloorPlan& plan,
                 const simulator::CameraSettings& camera, std::uint64_t seed)
      : world_(world), plan_(plan), camera_(camera), seed_(seed) {
    show_without(simulator::LateObstacles(world, plan).absent());
  }
  StereoFrame image(const simulator::SceneState& scene) override {
    if (scene.absent != absent_) show_without(scene.absent);
    return renderer_->image(scene);
  }
  [[nodiscard]] double light_level(Point2 place) const override {
    return renderer_->light_level(place);
  }
  [[nodiscard]] simulator::Renderer& renderer() { return *renderer_; }

 private:
  void show_without(const std::vector<std::size_t>& absent) {
    absent_ = absent;
    renderer_ =
        simulator::Renderer(simulator::world_without(world_, absent), plan_, camera_, seed_);
  }

  simulator::World world_;
  simulator::FloorPlan plan_;
  simulator::CameraSettings camera_;
  std::uint64_t seed_;
  std::vector<std::size_t> absent_;
  std::optional<simulator::Renderer> renderer_;  // its address stays
};

}  // namespace striate::simulator
