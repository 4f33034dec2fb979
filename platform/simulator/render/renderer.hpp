#pragma once

#include <cstdint>
#include <memory>
#include <opencv2/core/mat.hpp>

#include "striate/platform/simulator/render/camera_settings.hpp"
#include "striate/platform/simulator/scene.hpp"

namespace striate::simulator {

/// The eyes of the simulated Pioneer: what its stereo head sees of a world, by ray casting with
/// baked light, through the model of a real camera. Deterministic: the same world, seed and
/// sequence of states give the same bytes. One thread; several renderers may run in several
/// threads.
class Renderer {
 public:
  /// Builds and lights the world (about a second). Throws UserError for a material or image
  /// that is neither shipped nor a readable file.
  Renderer(const World& world, const FloorPlan& plan, const CameraSettings& settings,
           std::uint64_t seed);
  ~Renderer();
  Renderer(Renderer&&) noexcept;
  Renderer& operator=(Renderer&&) noexcept;

  /// What both cameras see. Exposure control goes on from image to image; noise depends on
  /// the seed and `state.frame`. Left for the caller: `stamp` and `head`.
  [[nodiscard]] StereoFrame image(const SceneState& state);

  /// Depth in metres along the left camera's optical axis, +inf where nothing is (the outdoors),
  /// in an image of `width_px` and three quarters of that. For judging only.
  [[nodiscard]] cv::Mat1f true_depth(const SceneState& state, int width_px);

  /// Light on the floor's things at a place, lamps, sky and what walls reflect: 0 dark .. 1 as
  /// bright as an office corridor (or brighter). Direct sun is not counted.
  [[nodiscard]] double light_level(Point2 plan) const;

  /// How the last image was exposed.
  struct LastExposure {
    double shutter_s = 0.0;
    double gain = 1.0;
  };
  [[nodiscard]] LastExposure last_exposure() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace striate::simulator
