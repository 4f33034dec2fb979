#include <numbers>

#include "striate/platform/simulator/render/baked_light.hpp"

namespace striate::simulator::render {

LampSample lamp_sample(const Lamp& lamp, Vec3 point, Vec3 normal, int sample, int samples) {
  // One row along the panel, or two where the point is near enough to see its width.
  const int rows = samples > 4 ? 2 : 1;
  const int columns = samples / rows;
  const auto spread = [](int i, int n) {
    return (2.0F * static_cast<float>(i) + 1.0F) / static_cast<float>(n) - 1.0F;
  };
  const Vec3 from = lamp.centre + lamp.along * spread(sample % columns, columns) +
                    lamp.across * spread(sample / columns, rows);
  const Vec3 way = from - point;
  const float r2 = std::max(dot(way, way), 0.04F);
  const float r = std::sqrt(r2);
  const float here = dot(normal, way) / r;
  const float there = -dot(way, lamp.facing) / r;
  if (here <= 0.0F || there <= 0.0F) return {from, 0.0F};
  const float area = lamp.area_m2() / static_cast<float>(samples);
  return {from, lamp.exitance * area * here * there / (r2 * std::numbers::pi_v<float>)};
}

std::vector<Vec3> cosine_directions(int count) {
  std::vector<Vec3> directions;
  const float golden = std::numbers::pi_v<float> * (3.0F - std::sqrt(5.0F));
  for (int i = 0; i < count; ++i) {
    const float r2 = (static_cast<float>(i) + 0.5F) / static_cast<float>(count);
    const float r = std::sqrt(r2);
    const float a = golden * static_cast<float>(i);
    directions.push_back({r * std::cos(a), r * std::sin(a), std::sqrt(1.0F - r2)});
  }
  return directions;
}

std::vector<Vec3> sphere_directions(int count) {
  std::vector<Vec3> directions;
  const float golden = std::numbers::pi_v<float> * (3.0F - std::sqrt(5.0F));
  for (int i = 0; i < count; ++i) {
    const float z = 1.0F - (2.0F * static_cast<float>(i) + 1.0F) / static_cast<float>(count);
    const float r = std::sqrt(std::max(0.0F, 1.0F - z * z));
    const float a = golden * static_cast<float>(i);
    directions.push_back({r * std::cos(a), r * std::sin(a), z});
  }
  return directions;
}

}  // namespace striate::simulator::render
