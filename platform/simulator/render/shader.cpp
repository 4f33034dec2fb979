#include "striate/platform/simulator/render/shader.hpp"

namespace striate::simulator::render {
Shader::Surroundings Shader::look_at(const Packet& packet, unsigned lane, float spread,
                                     float before_m) const {
  Surroundings look;
  look.person = packet.rays.hit.geomID[lane] == Tracer::kPeople;
  const unsigned number = packet.rays.hit.primID[lane];
  const Patch& patch = look.person ? people_.patches()[number] : stage_.patches[number];
  look.patch = &patch;
  look.material = &stage_.materials[patch.material];
  const V4* light = look.person ? people_.light().data() : baked_.texels.data();
  look.light = {light + patch.light_at, patch.light_u, patch.light_v};
  if (stage_.sun && patch.may_see_sun) {
    look.sun = stage_.sun->irradiance * std::max(0.0F, dot(patch.normal, stage_.sun->towards));
  }
  // Between the pixel's narrow and its long side on the surface: a little soft, never aliased.
  const Vec3 direction = packet.direction(lane);
  const float speed = length(direction);
  const float facing = std::abs(dot(direction, patch.normal)) / speed;
  const float pixel_m = (packet.rays.ray.tfar[lane] * speed + before_m) * spread;
  const float texels = pixel_m * patch.texels_per_m;
  const float level = 0.5F * fast_log2(texels * texels / std::max(facing, 0.03F) + 1e-9F);
  look.level = {&look.material->texture->level(level - 0.35F),
                &look.material->texture->level(level + 0.15F)};
  return look;
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
      // Cosine times the ball's solid angle; fades out towards the reach, whose border is not seen.
      const float hidden =
          std::min(0.85F, std::max(0.0F, dot(way, normal)) * r2 / (d2 * std::sqrt(d2)));
      open *=
          1.0F -
          hidden * std::max(0.0F, 1.0F - d2 * (1.0F / (Occluder::kReach_m * Occluder::kReach_m)));
    }
  }
  return open;
}

/// Whether any hit may lie in somebody's contact shadow.
bool Shader::people_near(const Packet& packet) const {
  if (people_.occluders().empty()) return false;
  float low_x = 1e9F;
  float high_x = -1e9F;
  float low_y = 1e9F;
  float high_y = -1e9F;
  for (unsigned i = 0; i < Packet::kSize; ++i) {
    if (packet.valid[i] == 0 || !packet.hit(i)) continue;
    const Vec3 p = packet.place(i);
    low_x = std::min(low_x, p.x);
    high_x = std::max(high_x, p.x);
    low_y = std::min(low_y, p.y);
    high_y = std::max(high_y, p.y);
  }
  for (const Occluder& person : people_.occluders()) {
    const Vec3 p = person.foot;
    // How far from a person's foot the floor is darkened
    constexpr float kReach_m = Occluder::kReach_m;
    if (p.x > low_x - kReach_m && p.x < high_x + kReach_m && p.y > low_y - kReach_m &&
        p.y < high_y + kReach_m) {
      return true;
    }
  }
  return false;
}

/// Leaves `sun` at the lanes that the sun reaches, clears it at the others.
void Shader::cast_to_sun(const Packet& packet, const std::array<Vec3, Packet::kSize>& normal,
                         std::array<float, Packet::kSize>& sun) const {
  Packet shadow;
  for (unsigned i = 0; i < Packet::kSize; ++i) {
    shadow.clear(i);
    if (sun[i] > 0.0F)
      shadow.set(i, packet.place(i) + normal[i] * 0.003F, stage_.sun->towards, 0.001F, 1e4F);
  }
  tracer_.occlude(shadow);
  for (unsigned i = 0; i < Packet::kSize; ++i) {
    if (sun[i] > 0.0F && shadow.rays.ray.tfar[i] < 0.0F) sun[i] = 0.0F;
  }
}

/// Sixteen rays that all meet one patch: nearly nine packets in ten.
bool Shader::on_one_patch(const Packet& packet) {
  const unsigned patch = packet.rays.hit.primID[0];
  const unsigned kind = packet.rays.hit.geomID[0];
  unsigned differs = kind == RTC_INVALID_GEOMETRY_ID ? 1U : 0U;
  for (unsigned i = 0; i < Packet::kSize; ++i) {
    differs |= (packet.rays.hit.primID[i] ^ patch) | (packet.rays.hit.geomID[i] ^ kind) |
               static_cast<unsigned>(packet.valid[i] + 1);
  }
  return differs == 0;
}

/// What reaches the eye of the light on the lane's place; what the sun adds comes later.
void Shader::light_up(const Packet& packet, unsigned lane, const Surroundings& look, Lanes& lanes,
                      Shaded& out) const {
  const Patch& patch = *look.patch;
  V4 light = lanes.light[lane];
  if (look.sun > 0.0F && light[3] > 0.0F) {
    lanes.sun[lane] = look.sun;
    lanes.normal[lane] = patch.normal;
    lanes.any_sun = true;
  }
  light *= splat(lanes.people && !look.person
                     ? flicker_ * hidden_by_people(packet.place(lane), patch.normal)
                     : flicker_);
  const float mirror = lanes.mirror[lane];
  lanes.albedo[lane] *= splat(1.0F - mirror);
  out.colour = lanes.albedo[lane] * light;
  out.colour[3] = mirror;
}

void Shader::shade_one_patch(const Packet& packet, const Surroundings& look, Lanes& lanes,
                             Shaded* out) const {
  for (unsigned i = 0; i < Packet::kSize; ++i) out[i].group = look.patch->group;
  if (look.material->shines) {
    for (unsigned i = 0; i < Packet::kSize; ++i) out[i].colour = look.material->emission;
    return;
  }
  const PacketTexture surface{look.material->texture.get(), look.level, look.patch->s,
                              look.patch->t};
  sample_packet(surface, packet.rays.hit.u, packet.rays.hit.v, lanes.albedo.data());
  light_packet(look.light, packet.rays.hit.u, packet.rays.hit.v, lanes.light.data());
  if (look.material->gloss > 0.0F) {
    const RTCRay16& rays = packet.rays.ray;
    mirror_packet(look.material->gloss, look.patch->normal, rays.dir_x, rays.dir_y, rays.dir_z,
                  lanes.mirror.data());
  }
  for (unsigned i = 0; i < Packet::kSize; ++i) light_up(packet, i, look, lanes, out[i]);
}

void Shader::shade_lane(const Packet& packet, unsigned lane, const Surroundings& look, Lanes& lanes,
                        Shaded& out) const {
  out.group = look.patch->group;
  if (look.material->shines) {
    out.colour = look.material->emission;
    return;
  }
  const float u = packet.rays.hit.u[lane];
  const float v = packet.rays.hit.v[lane];
  lanes.albedo[lane] = look.material->texture->sample(*look.level[(lane ^ (lane >> 2U)) & 1U],
                                                      Patch::at(look.patch->s, u, v),
                                                      Patch::at(look.patch->t, u, v));
  lanes.light[lane] = baked_light_at(look.light, u, v);
  if (look.material->gloss > 0.0F) {
    const Vec3 d = packet.direction(lane);
    const float facing = std::abs(dot(d, look.patch->normal)) / length(d);
    lanes.mirror[lane] = mirrored(look.material->gloss, facing);
  }
  light_up(packet, lane, look, lanes, out);
}

void Shader::shade(const Packet& packet, float spread, const float* before_m, Shaded* out) const {
  Lanes lanes;
  lanes.people = people_near(packet);
  const auto look_along = [&](unsigned i) {
    return look_at(packet, i, spread, before_m == nullptr ? 0.0F : before_m[i]);
  };
  if (on_one_patch(packet)) {
    shade_one_patch(packet, look_along(0), lanes, out);
  } else {
    Surroundings look;
    unsigned seen = RTC_INVALID_GEOMETRY_ID;  // the patch that `look` is of
    for (unsigned i = 0; i < Packet::kSize; ++i) {
      if (packet.valid[i] == 0) continue;
      if (!packet.hit(i)) {
        out[i].colour = stage_.outdoors(packet.direction(i)) * splat(stage_.sky);
        out[i].colour[3] = 0.0F;
        out[i].group = kNothing;
        continue;
      }
      const unsigned id = packet.rays.hit.primID[i] * 2 + packet.rays.hit.geomID[i];
      if (id != seen || look.patch == nullptr) look = look_along(i);
      seen = id;
      shade_lane(packet, i, look, lanes, out[i]);
    }
  }
  if (!lanes.any_sun) return;
  cast_to_sun(packet, lanes.normal, lanes.sun);
  for (unsigned i = 0; i < Packet::kSize; ++i) {
    if (lanes.sun[i] > 0.0F)
      out[i].colour += lanes.albedo[i] * bgr(0.86F, 0.97F, 1.06F) * splat(lanes.sun[i]);
  }
}

}  // namespace striate::simulator::render
