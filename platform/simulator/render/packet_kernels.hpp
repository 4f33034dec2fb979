#pragma once

#include <array>
#include <cstdint>

#include "platform/simulator/render/texture.hpp"
#include "platform/simulator/render/vec.hpp"

/// What is done to sixteen rays at once, on the best instruction set of the machine; the results
/// are bit for bit those of the plain code named beside each.
namespace striate::simulator::render {

inline constexpr int kPacket = 16;

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

}  // namespace striate::simulator::render
