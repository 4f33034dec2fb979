#include "platform/simulator/render/shader.hpp"

namespace striate::simulator::render {
namespace {

V4 light_at(const Patch& patch, const V4* texels, float u, float v) {
  const float x = u * static_cast<float>(patch.light_u - 1);
  const float y = v * static_cast<float>(patch.light_v - 1);
  const int i = std::clamp(static_cast<int>(x), 0, patch.light_u - 2);
  const int j = std::clamp(static_cast<int>(y), 0, patch.light_v - 2);
  const float fx = x - static_cast<float>(i);
  const float fy = y - static_cast<float>(j);
  const V4* at = texels + patch.light_at + j * patch.light_u + i;
  return lerp(lerp(at[0], at[1], fx), lerp(at[patch.light_u], at[patch.light_u + 1], fx), fy);
}

/// Weight of the mirror image: Schlick's approximation for a polished floor (F0 = 0.04).
float mirrored(float gloss, float facing) {
  const float k = 1.0F - facing;
  return gloss * (0.04F + 0.96F * (k * k) * (k * k) * k);
}

}  // namespace

Shader::Surface Shader::look_up(const Packet& packet, unsigned lane, float spread,
                                float before_m) const {
  const bool person = packet.rays.hit.geomID[lane] == Tracer::kPeople;
  const Patch& patch = person ? people_.patches()[packet.rays.hit.primID[lane]]
                              : stage_.patches[packet.rays.hit.primID[lane]];
  const Material& material = stage_.materials[patch.material];
  const Vec3 direction = packet.direction(lane);
  const float speed = length(direction);
  Surface surface;
  surface.patch = &patch;
  surface.place = packet.place(lane);
  surface.facing = std::abs(dot(direction, patch.normal)) / speed;
  const float u = packet.rays.hit.u[lane];
  const float v = packet.rays.hit.v[lane];
  if (material.shines) {
    surface.albedo = material.emission;
    surface.light = splat(1.0F);
    return surface;
  }
  // Between the pixel's narrow and its long side on the surface: a little soft, never aliased.
  const float pixel_m = (packet.rays.ray.tfar[lane] * speed + before_m) * spread;
  const float stretched = pixel_m * pixel_m / std::max(surface.facing, 0.03F);
  const float level = 0.5F * fast_log2(stretched * patch.texels_per_m * patch.texels_per_m + 1e-9F);
  surface.albedo =
      material.texture->sample(Patch::at(patch.s, u, v), Patch::at(patch.t, u, v), level);
  surface.light = light_at(patch, person ? people_.light().data() : baked_.texels.data(), u, v);
  return surface;
}

float Shader::hidden_by_people(Vec3 place, Vec3 normal) const {
  float open = 1.0F;
  for (const Occluder& person : people_.occluders()) {
    const float dx = person.foot.x - place.x;
    const float dy = person.foot.y - place.y;
    if (dx * dx + dy * dy > Occluder::kReach_m * Occluder::kReach_m) continue;
    for (const Occluder::Ball& ball : person.balls) {
      const Vec3 way = ball.centre - place;
      const float r2 = ball.radius_m * ball.radius_m;
      const float d2 = std::max(dot(way, way), r2);
      const float d = std::sqrt(d2);
      // Fades out towards the reach, so that its border is not seen.
      const float near = std::max(0.0F, 1.0F - d2 / (Occluder::kReach_m * Occluder::kReach_m));
      open *= 1.0F - near * std::min(0.85F, std::max(0.0F, dot(way, normal) / d) * r2 / d2);
    }
  }
  return open;
}

void Shader::add_sun(Surface* surfaces, const std::array<int, Packet::kSize>& wanted) const {
  Packet shadow;
  for (unsigned i = 0; i < Packet::kSize; ++i) {
    shadow.valid[i] = 0;
    if (wanted[i] == 0) continue;
    const Vec3 from = surfaces[i].place + surfaces[i].patch->normal * 0.003F;
    shadow.set(i, from, stage_.sun->towards, 0.001F, 1e4F);
  }
  tracer_.occlude(shadow);
  for (unsigned i = 0; i < Packet::kSize; ++i) {
    if (wanted[i] == 0 || shadow.rays.ray.tfar[i] < 0.0F) continue;
    const float facing = dot(surfaces[i].patch->normal, stage_.sun->towards);
    surfaces[i].light += bgr(0.86F, 0.97F, 1.06F) * splat(stage_.sun->irradiance * facing);
  }
}

void Shader::shade(const Packet& packet, float spread, const float* before_m, Shaded* out) const {
  std::array<Surface, Packet::kSize> surfaces;
  std::array<int, Packet::kSize> sunny{};
  bool any_sun = false;
  const bool people = !people_.occluders().empty();
  for (unsigned i = 0; i < Packet::kSize; ++i) {
    if (packet.valid[i] == 0 || !packet.hit(i)) continue;
    surfaces[i] = look_up(packet, i, spread, before_m == nullptr ? 0.0F : before_m[i]);
    Surface& s = surfaces[i];
    const bool person = packet.rays.hit.geomID[i] == Tracer::kPeople;
    const float sun_here = s.light[3];
    s.light *= flicker_;
    if (people && !person && !stage_.materials[s.patch->material].shines) {
      s.light *= splat(hidden_by_people(s.place, s.patch->normal));
    }
    if (stage_.sun && s.patch->may_see_sun && sun_here > 0.0F &&
        dot(s.patch->normal, stage_.sun->towards) > 0.0F) {
      sunny[i] = 1;
      any_sun = true;
    }
  }
  if (any_sun) add_sun(surfaces.data(), sunny);
  for (unsigned i = 0; i < Packet::kSize; ++i) {
    if (packet.valid[i] == 0) continue;
    if (!packet.hit(i)) {
      out[i].colour = stage_.outdoors(packet.direction(i)) * splat(stage_.sky);
      out[i].colour[3] = 0.0F;
      out[i].group = kNothing;
      continue;
    }
    const Surface& s = surfaces[i];
    const float mirror = mirrored(stage_.materials[s.patch->material].gloss, s.facing);
    out[i].colour = s.albedo * s.light * splat(1.0F - mirror);
    out[i].colour[3] = mirror;
    out[i].group = s.patch->group;
  }
}

}  // namespace striate::simulator::render
