#pragma once

#include <array>
#include <cstdint>

#include "striate/platform/simulator/render/texture.hpp"
#include "striate/platform/simulator/render/vec.hpp"
#include "striate/platform/simulator/render/view.hpp"

/// What is done to sixteen rays at once, on the best instruction set of the machine; the results
/// are bit for bit those of the plain code named beside each.
namespace striate::simulator::render {

inline constexpr int kPacket = 16;  ///< rays: Embree's widest packet

/// A texture as the rays that meet one patch see it.
struct PacketTexture {
  const Texture* texture = nullptr;
  /// Mip levels of the lanes where (lane ^ lane / 4) is even, and odd.
  std::array<const Texture::Level*, 2> level{};
  std::array<float, 4> s{};  ///< Patch::s
  std::array<float, 4> t{};
};

/// Albedo at sixteen places of one patch: Patch::at, then Texture::sample.
/// @param u, v kPacket numbers each: of Embree's hits
/// @param albedo kPacket colours
void sample_packet(const PacketTexture& surface, const float* u, const float* v, V4* albedo);

/// A patch's map of baked light; see Patch.
struct PacketLight {
  const V4* texels = nullptr;  ///< the patch's first
  int across = 2;
  int down = 2;
};

/// Baked light at sixteen places of one patch: baked_light_at.
void light_packet(const PacketLight& map, const float* u, const float* v, V4* light);

/// Weight of the mirror image along sixteen rays: mirrored.
/// @param x, y, z kPacket numbers each: directions, of any length
void mirror_packet(float gloss, Vec3 normal, const float* x, const float* y, const float* z,
                   float* mirror);

/// Directions of the rays of a tile of 4x4 pixels: View::ray.
void aim_packet(const View& view, int left, int top, float* x, float* y, float* z);

/// Bilinear, in a patch's map of baked light.
[[nodiscard]] inline V4 baked_light_at(const PacketLight& map, float u, float v) {
  const float x = u * static_cast<float>(map.across - 1);
  const float y = v * static_cast<float>(map.down - 1);
  const int i = std::min(static_cast<int>(x), map.across - 2);
  const int j = std::min(static_cast<int>(y), map.down - 2);
  const float fx = x - static_cast<float>(i);
  const float fy = y - static_cast<float>(j);
  const V4* at = map.texels + j * map.across + i;
  return lerp(lerp(at[0], at[1], fx), lerp(at[map.across], at[map.across + 1], fx), fy);
}

/// Weight of the mirror image: Schlick's approximation for a polished floor (F0 = 0.04).
/// @param facing cosine between the ray and the surface's normal, not negative
[[nodiscard]] inline float mirrored(float gloss, float facing) {
  const float k = 1.0F - facing;
  return gloss * (0.04F + 0.96F * (k * k) * (k * k) * k);
}

}  // namespace striate::simulator::render
