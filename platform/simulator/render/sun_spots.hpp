#pragma once

#include <numbers>

#include "striate/platform/simulator/render/stage.hpp"

namespace striate::simulator::render {

/// Where light is measured for a texel: a little off the face and off its border, so that it
/// is not inside what stands against it.
[[nodiscard]] inline Vec3 measuring_place(const Patch& patch, float u, float v) {
  const float wide = length(patch.corner[1] - patch.corner[0]);
  const float tall = length(patch.corner[3] - patch.corner[0]);
  const auto inset = [](float x, float size) {
    const float edge = std::min(0.1F, 0.02F / std::max(size, 1e-3F));
    return std::clamp(x, edge, 1.0F - edge);
  };
  const float off = std::min(wide, tall) > 0.6F ? 0.03F : 0.004F;
  return Patch::at(patch.corner, inset(u, wide), inset(v, tall)) + patch.normal * off;
}
template <class Function>
void for_texels(const Patch& patch, Function function) {
  for (int j = 0; j < patch.light_v; ++j) {
    for (int i = 0; i < patch.light_u; ++i) {
      function(patch.light_at + j * patch.light_u + i,
               static_cast<float>(i) / static_cast<float>(patch.light_u - 1),
               static_cast<float>(j) / static_cast<float>(patch.light_v - 1));
    }
  }
}

/// A piece of floor or wall in the sun, as a source. Few rays of a texel's look around would meet
/// these small, very bright places: as sources they light evenly.
struct SunSpot {
  Vec3 centre;
  Vec3 normal;
  V4 flux{};  ///< radiosity times area

  /// Irradiance per flux at a point on a face with this normal, unshadowed.
  [[nodiscard]] float weight_at(Vec3 point, Vec3 facing) const {
    const Vec3 way = centre - point;
    const float r2 = dot(way, way);
    const float here = dot(way, facing);
    const float there = -dot(way, normal);
    if (here <= 0.0F || there <= 0.0F || r2 > 150.0F) return 0.0F;
    // A spot is no point: nearer than its own size it does not get brighter.
    const float soft = r2 + 0.12F;
    return here * there / (soft * soft * std::numbers::pi_v<float>);
  }
};

/// The sunlit pieces of a patch, about half a metre each. `direct`: light map whose lane 3 is the
/// share of each texel in the sun. Only where the stage has a sun.
[[nodiscard]] std::vector<SunSpot> sun_spots(const Stage& stage, const Patch& patch,
                                             const std::vector<V4>& direct);

}  // namespace striate::simulator::render
