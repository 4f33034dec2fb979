#include "striate/platform/simulator/render/light_probes.hpp"

namespace striate::simulator::render {
namespace {

constexpr int kRaysPerProbe = 96;                               // rays a probe; as baked_light.cpp
constexpr std::array<float, 3> kHeight_m{0.15F, 0.95F, 1.75F};  // a person's feet, hips and head
/// The six sides that a probe is lit from
constexpr std::array<Vec3, 6> kAxis{
    {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}};

bool inside(const std::vector<Point2>& outline, double x, double y) {
  bool in = false;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Point2& p = outline[i];
    const Point2& q = outline[(i + 1) % outline.size()];
    if ((p.y_m > y) == (q.y_m > y)) continue;
    if (x < p.x_m + (y - p.y_m) * (q.x_m - p.x_m) / (q.y_m - p.y_m)) in = !in;
  }
  return in;
}

}  // namespace

LightProbes::LightProbes(const Stage& stage, const FloorPlan& plan, const BakedLight& baked,
                         const Tracer& tracer)
    : directions_(sphere_directions(kRaysPerProbe)) {
  double x0 = 1e9;
  double x1 = -1e9;
  double y0 = 1e9;
  double y1 = -1e9;
  for (const Point2& p : plan.outline) {
    x0 = std::min(x0, p.x_m);
    x1 = std::max(x1, p.x_m);
    y0 = std::min(y0, p.y_m);
    y1 = std::max(y1, p.y_m);
  }
  // A quarter cell from the walls, so that narrow corridors have probes on both sides.
  x0_m_ = static_cast<float>(x0) + 0.25F * kCell_m;
  y0_m_ = static_cast<float>(y0) + 0.25F * kCell_m;
  columns_ = static_cast<int>((x1 - x0) / static_cast<double>(kCell_m)) + 1;
  rows_ = static_cast<int>((y1 - y0) / static_cast<double>(kCell_m)) + 1;
  probes_.resize(static_cast<std::size_t>(columns_ * rows_));
  for (int j = 0; j < rows_; ++j) {
    for (int i = 0; i < columns_; ++i) {
      Probe& probe = probes_[static_cast<std::size_t>(j * columns_ + i)];
      const Vec3 foot{x0_m_ + static_cast<float>(i) * kCell_m,
                      y0_m_ + static_cast<float>(j) * kCell_m, 0.0F};
      probe.inside = inside(plan.outline, static_cast<double>(foot.x), static_cast<double>(foot.y));
      if (!probe.inside) continue;
      for (std::size_t k = 0; k < kHeights; ++k) {
        probe.light[k] = measure(stage, baked, tracer, {foot.x, foot.y, kHeight_m[k]});
      }
    }
  }
}

std::array<V4, 6> LightProbes::measure(const Stage& stage, const BakedLight& baked,
                                       const Tracer& tracer, Vec3 point) const {
  std::array<V4, 6> light{};
  Packet packet;
  for (std::size_t first = 0; first < kRaysPerProbe; first += Packet::kSize) {
    for (unsigned k = 0; k < Packet::kSize; ++k)
      packet.set(k, point, directions_[first + k], 0.0F, 1e4F);
    tracer.intersect(packet, false);
    for (unsigned k = 0; k < Packet::kSize; ++k) {
      const Vec3 d = packet.direction(k);
      V4 radiosity = stage.outdoors(d) * splat(stage.sky);
      if (packet.hit(k)) {
        const Patch& patch = stage.patches[packet.rays.hit.primID[k]];
        const Material& material = stage.materials[patch.material];
        const bool back = dot(patch.normal, d) > 0.0F;
        const int texel = patch.light_at + patch.light_u * (patch.light_v / 2) + patch.light_u / 2;
        const auto u = static_cast<int>(
            std::floor(packet.rays.hit.u[k] * static_cast<float>(patch.light_u - 1) + 0.5F));
        const auto v = static_cast<int>(
            std::floor(packet.rays.hit.v[k] * static_cast<float>(patch.light_v - 1) + 0.5F));
        const int there = patch.light_at + std::clamp(v, 0, patch.light_v - 1) * patch.light_u +
                          std::clamp(u, 0, patch.light_u - 1);
        radiosity =
            material.texture->mean() * baked.texels[static_cast<std::size_t>(back ? texel : there)];
        if (back || material.shines) radiosity = V4{};
      }
      for (std::size_t a = 0; a < 6; ++a) {
        // Radiance is radiosity / pi; each direction stands for 4 pi / count of the sphere.
        light[a] += radiosity * splat(std::max(0.0F, dot(d, kAxis[a])) * 4.0F / kRaysPerProbe);
      }
    }
  }
  Packet shadow;
  for (const Lamp& lamp : stage.lamps) {
    if (length(lamp.centre - point) > 12.0F) continue;
    for (unsigned k = 0; k < Packet::kSize; ++k) shadow.clear(k);
    shadow.set(0, point, lamp.centre - point, 0.0F, 0.99F);
    tracer.occlude(shadow);
    if (shadow.rays.ray.tfar[0] < 0.0F) continue;
    for (std::size_t a = 0; a < 6; ++a)
      light[a] += splat(lamp_sample(lamp, point, kAxis[a], 0, 1).irradiance);
  }
  return light;
}

const LightProbes::Probe* LightProbes::at(int i, int j) const {
  if (i < 0 || j < 0 || i >= columns_ || j >= rows_) return nullptr;
  const Probe* probe = &probes_[static_cast<std::size_t>(j * columns_ + i)];
  return probe->inside ? probe : nullptr;
}

V4 LightProbes::irradiance(Vec3 point, Vec3 normal) const {
  const float x = (point.x - x0_m_) / kCell_m;
  const float y = (point.y - y0_m_) / kCell_m;
  const float fx = std::floor(x);
  const float fy = std::floor(y);
  const float h =
      std::clamp((point.z - kHeight_m[0]) / (kHeight_m[1] - kHeight_m[0]), 0.0F, 1.999F);
  const auto low = static_cast<std::size_t>(h);
  const float up = h - static_cast<float>(low);
  const std::array<float, 3> n{normal.x, normal.y, normal.z};
  V4 sum{};
  float weights = 0.0F;
  for (int dj = 0; dj < 2; ++dj) {
    for (int di = 0; di < 2; ++di) {
      const Probe* probe = at(static_cast<int>(fx) + di, static_cast<int>(fy) + dj);
      if (probe == nullptr) continue;
      const float weight =
          1e-3F + (di == 1 ? x - fx : 1.0F - (x - fx)) * (dj == 1 ? y - fy : 1.0F - (y - fy));
      weights += weight;
      for (std::size_t a = 0; a < 3; ++a) {
        const std::size_t side = 2 * a + (n[a] < 0.0F ? 1 : 0);
        const V4 light = lerp(probe->light[low][side], probe->light[low + 1][side], up);
        sum += light * splat(weight * n[a] * n[a]);
      }
    }
  }
  return weights > 0.0F ? sum * splat(1.0F / weights) : V4{};
}

}  // namespace striate::simulator::render
