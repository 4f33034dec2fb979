#include "striate/platform/simulator/render/sun_spots.hpp"

namespace striate::simulator::render {
namespace {

std::size_t index_of(int i) {
  return static_cast<std::size_t>(i);
}

}  // namespace

std::vector<SunSpot> sun_spots(const Stage& stage, const Patch& patch,
                               const std::vector<V4>& direct) {
  std::vector<SunSpot> spots;
  const Material& material = stage.materials[patch.material];
  const float facing = dot(patch.normal, stage.sun->towards);
  if (facing <= 0.02F || material.shines) return spots;
  const float wide = length(patch.corner[1] - patch.corner[0]);
  const float tall = length(patch.corner[3] - patch.corner[0]);
  const int columns = std::max(1, static_cast<int>(wide / 0.5F));
  const int rows = std::max(1, static_cast<int>(tall / 0.5F));
  spots.resize(index_of(columns * rows));
  const float area = wide * tall / static_cast<float>((patch.light_u - 1) * (patch.light_v - 1));
  const V4 radiosity = material.texture->mean() * splat(stage.sun->irradiance * facing * area);
  for_texels(patch, [&](int texel, float u, float v) {
    const float share = direct[index_of(texel)][3];
    if (share <= 0.0F) return;
    const int column = std::min(static_cast<int>(u * static_cast<float>(columns)), columns - 1);
    const int row = std::min(static_cast<int>(v * static_cast<float>(rows)), rows - 1);
    SunSpot& spot = spots[index_of(row * columns + column)];
    // Lane 3 sums the shares, to find the middle.
    spot.flux += radiosity * splat(share) + V4{0.0F, 0.0F, 0.0F, share};
    spot.centre = spot.centre + measuring_place(patch, u, v) * share;
    spot.normal = patch.normal;
  });
  std::erase_if(spots, [](const SunSpot& spot) { return spot.flux[3] <= 0.0F; });
  for (SunSpot& spot : spots) {
    spot.centre = spot.centre * (1.0F / spot.flux[3]);
    spot.flux[3] = 0.0F;
  }
  return spots;
}

}  // namespace striate::simulator::render
