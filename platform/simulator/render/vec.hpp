#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

/// Small vectors of the renderer. Colours are linear light, lanes blue, green, red and one spare.
namespace striate::simulator::render {

using V4 = float __attribute__((vector_size(16)));
using I4 = std::int32_t __attribute__((vector_size(16)));

[[nodiscard]] inline V4 splat(float value) {
  return V4{value, value, value, value};
}
[[nodiscard]] inline V4 bgr(float blue, float green, float red, float spare = 0.0F) {
  return V4{blue, green, red, spare};
}
[[nodiscard]] inline V4 lerp(V4 a, V4 b, float weight) {
  return a + (b - a) * splat(weight);
}
[[nodiscard]] inline float luminance(V4 c) {
  return 0.11F * c[0] + 0.59F * c[1] + 0.30F * c[2];
}

/// Metres in the plan: x, y as the floor plan has them, z up from the floor.
struct Vec3 {
  float x = 0.0F;
  float y = 0.0F;
  float z = 0.0F;
};

[[nodiscard]] inline Vec3 operator+(Vec3 a, Vec3 b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
[[nodiscard]] inline Vec3 operator-(Vec3 a, Vec3 b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
[[nodiscard]] inline Vec3 operator*(Vec3 a, float k) {
  return {a.x * k, a.y * k, a.z * k};
}
[[nodiscard]] inline float dot(Vec3 a, Vec3 b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
[[nodiscard]] inline Vec3 cross(Vec3 a, Vec3 b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
[[nodiscard]] inline float length(Vec3 a) {
  return std::sqrt(dot(a, a));
}
[[nodiscard]] inline Vec3 unit(Vec3 a) {
  const float l = length(a);
  return l > 0.0F ? a * (1.0F / l) : Vec3{0.0F, 0.0F, 1.0F};
}

/// Base-2 logarithm to about 0.01, for choosing a mip level.
[[nodiscard]] inline float fast_log2(float x) {
  std::uint32_t bits = 0;
  std::memcpy(&bits, &x, sizeof bits);
  const float exponent = static_cast<float>(static_cast<int>(bits >> 23U) - 127);
  bits = (bits & 0x007FFFFFU) | 0x3F800000U;
  float mantissa = 0.0F;
  std::memcpy(&mantissa, &bits, sizeof mantissa);
  return exponent + (mantissa - 1.0F) * (1.3465F - 0.3465F * (mantissa - 1.0F));
}

}  // namespace striate::simulator::render
