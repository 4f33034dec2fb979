#include "striate/platform/simulator/render/baked_light.hpp"

#include "striate/platform/simulator/render/shadow_rays.hpp"
#include "striate/platform/simulator/render/sun_spots.hpp"

namespace striate::simulator::render {
namespace {

/// Rays a patch, over the half space before it: time against grain (ours)
constexpr int kDirections = 96;
/// Each brings less than a wall's albedo of the one before: time against light (ours)
constexpr int kBounces = 4;
constexpr float kFar = 1e4F;           ///< m: farther than any corridor
constexpr float kNearWindow_m = 1.1F;  ///< reveals and frames look around instead
constexpr int kDark = -1;              ///< the ray ended on something's back or on a lamp

class Baker {
 public:
  Baker(Stage& stage, const Tracer& tracer)
      : stage_(stage),
        tracer_(tracer),
        direct_(static_cast<std::size_t>(stage.light_texels), V4{}),
        indirect_(direct_),
        radiosity_(direct_),
        directions_(cosine_directions(kDirections)) {}

  BakedLight bake() {
    light_directly();
    light_by_sun_spots();
    gather();
    for (int bounce = 0; bounce < kBounces; ++bounce) pass_on();
    return finished();
  }

 private:
  struct Gathered {  ///< where the light of one texel comes from
    int texel = 0;
    V4 sky{};
    std::array<int, kDirections> source{};
  };

  void light_directly() {
    ShadowRays rays(tracer_, [this](int texel, V4 light) { direct_[at(texel)] += light; });
    for (const Patch& patch : stage_.patches) {
      for_texels(patch, [&](int texel, float u, float v) {
        const Vec3 point = measuring_place(patch, u, v);
        const Vec3 normal = unit(Patch::at(patch.bend, u, v));
        for (const Lamp& lamp : stage_.lamps) add_lamp(rays, lamp, normal, point, texel);
        for (const Lamp& window : stage_.windows) add_window(rays, window, normal, point, texel);
        add_sun(rays, patch, {u, v}, texel);
      });
    }
    rays.flush();
  }

  void add_lamp(ShadowRays& rays, const Lamp& lamp, Vec3 normal, Vec3 point, int texel) {
    const float away = length(lamp.centre - point);
    if (away > 16.0F) return;
    const int samples = away < 3.5F ? 8 : (away < 7.0F ? 4 : 1);
    for (int k = 0; k < samples; ++k) {
      const LampSample s = lamp_sample(lamp, point, normal, k, samples);
      if (s.irradiance < 1e-5F) continue;
      // Ends just before the panel.
      rays.add(point, s.from - point, 0.995F, texel, bgr(0.93F, 1.0F, 0.98F) * splat(s.irradiance));
    }
  }

  /// The sky through a window: as bright as it is in that direction.
  void add_window(ShadowRays& rays, const Lamp& window, Vec3 normal, Vec3 point, int texel) {
    const float away = length(window.centre - point);
    if (away < kNearWindow_m || away > 20.0F || dot(point - window.centre, window.facing) <= 0.0F)
      return;
    const int samples = away < 6.0F ? 8 : 4;
    for (int k = 0; k < samples; ++k) {
      const LampSample s = lamp_sample(window, point, normal, k, samples);
      if (s.irradiance * stage_.sky < 1e-4F) continue;
      const V4 light = stage_.outdoors(s.from - point) * splat(stage_.sky * s.irradiance);
      rays.add(point, s.from - point, 1.0F, texel, bgr(light[0], light[1], light[2]));
    }
  }

  struct Uv {
    float u, v;
  };
  void add_sun(ShadowRays& rays, const Patch& patch, Uv uv, int texel) {
    if (!stage_.sun || dot(patch.normal, stage_.sun->towards) <= 0.02F) return;
    for (const float du : {-0.25F, 0.25F}) {
      for (const float dv : {-0.25F, 0.25F}) {
        const float u = uv.u + du / static_cast<float>(patch.light_u - 1);
        const float v = uv.v + dv / static_cast<float>(patch.light_v - 1);
        rays.add(measuring_place(patch, std::clamp(u, 0.0F, 1.0F), std::clamp(v, 0.0F, 1.0F)),
                 stage_.sun->towards, kFar, texel, V4{0.0F, 0.0F, 0.0F, 0.25F});
      }
    }
  }

  void light_by_sun_spots() {
    if (!stage_.sun) return;
    std::vector<SunSpot> spots;
    for (const Patch& patch : stage_.patches) {
      const std::vector<SunSpot> more = sun_spots(stage_, patch, direct_);
      spots.insert(spots.end(), more.begin(), more.end());
    }
    ShadowRays rays(tracer_, [this](int texel, V4 light) { direct_[at(texel)] += light; });
    for (const Patch& patch : stage_.patches) {
      for_texels(patch, [&](int texel, float u, float v) {
        const Vec3 point = measuring_place(patch, u, v);
        const Vec3 normal = unit(Patch::at(patch.bend, u, v));
        for (const SunSpot& spot : spots) {
          const float weight = spot.weight_at(point, normal);
          if (weight * luminance(spot.flux) < 1e-3F) continue;
          rays.add(point, spot.centre - point, 0.97F, texel, spot.flux * splat(weight));
        }
      });
    }
    rays.flush();
  }
  /// Every second texel looks around once; where its light comes from never changes.
  void gather() {
    for (const Patch& patch : stage_.patches) {
      for_texels(patch, [&](int texel, float u, float v) {
        const int i = (texel - patch.light_at) % patch.light_u;
        const int j = (texel - patch.light_at) / patch.light_u;
        if (!carries(patch, i, j)) return;
        gathered_.push_back(
            look_around(unit(Patch::at(patch.bend, u, v)), measuring_place(patch, u, v), texel));
      });
    }
  }
  static bool carries(const Patch& patch, int i, int j) {
    return (patch.light_u == 2 || i % 2 == 0) && (patch.light_v == 2 || j % 2 == 0);
  }

  Gathered look_around(Vec3 n, Vec3 point, int texel) {
    Gathered found;
    found.texel = texel;
    const Vec3 a =
        unit(std::abs(n.z) < 0.9F ? cross({0.0F, 0.0F, 1.0F}, n) : cross({1.0F, 0.0F, 0.0F}, n));
    const Vec3 b = cross(n, a);
    const bool near = std::any_of(
        stage_.windows.begin(), stage_.windows.end(),
        [&](const Lamp& window) { return length(window.centre - point) < kNearWindow_m; });
    Packet packet;
    for (std::size_t first = 0; first < kDirections; first += Packet::kSize) {
      for (unsigned k = 0; k < Packet::kSize; ++k) {
        const Vec3 d = directions_[first + k];
        packet.set(k, point, a * d.x + b * d.y + n * d.z, 1e-4F, kFar);
      }
      tracer_.intersect(packet, false);
      for (unsigned k = 0; k < Packet::kSize; ++k) {
        found.source[first + k] = source_of(packet, k, near ? &found.sky : nullptr);
      }
    }
    return found;
  }

  int source_of(const Packet& packet, unsigned lane, V4* sky) const {
    const Vec3 d = packet.direction(lane);
    if (!packet.hit(lane)) {
      // From afar the windows have been counted as sources.
      if (sky != nullptr) *sky += stage_.outdoors(d) * splat(stage_.sky / kDirections);
      return kDark;
    }
    const Patch& patch = stage_.patches[packet.rays.hit.primID[lane]];
    if (dot(patch.normal, d) > 0.0F) return kDark;
    const auto nearest = [](float x, int count) {
      return std::clamp(static_cast<int>(std::floor(x * static_cast<float>(count - 1) + 0.5F)), 0,
                        count - 1);
    };
    return patch.light_at + nearest(packet.rays.hit.v[lane], patch.light_v) * patch.light_u +
           nearest(packet.rays.hit.u[lane], patch.light_u);
  }

  void pass_on() {
    for (const Patch& patch : stage_.patches) {
      const Material& material = stage_.materials[patch.material];
      const V4 albedo = material.shines ? V4{} : material.texture->mean();
      for (int t = patch.light_at; t < patch.light_at + patch.light_u * patch.light_v; ++t) {
        const V4 light = direct_[at(t)] + indirect_[at(t)];
        radiosity_[at(t)] = albedo * light;
      }
    }
    for (const Gathered& g : gathered_) {
      V4 sum{};
      for (const int source : g.source) {
        if (source != kDark) sum += radiosity_[at(source)];
      }
      indirect_[at(g.texel)] = sum * splat(1.0F / kDirections) + g.sky;
    }
    for (const Patch& patch : stage_.patches) spread(patch);
  }

  /// Fills the texels between those that carry indirect light, and smooths.
  void spread(const Patch& patch) {
    const auto texel = [&](int i, int j) -> V4& {
      return indirect_[at(patch.light_at + j * patch.light_u + i)];
    };
    const V4 half = splat(0.5F);
    for (int j = 0; j < patch.light_v; j += patch.light_v == 2 ? 1 : 2) {
      for (int i = 1; i + 1 < patch.light_u; i += 2)
        texel(i, j) = half * (texel(i - 1, j) + texel(i + 1, j));
    }
    for (int j = 1; j + 1 < patch.light_v; j += 2) {
      for (int i = 0; i < patch.light_u; ++i)
        texel(i, j) = half * (texel(i, j - 1) + texel(i, j + 1));
    }
    smooth(patch, patch.light_u, patch.light_v, 1, patch.light_u);
    smooth(patch, patch.light_v, patch.light_u, patch.light_u, 1);
  }
  /// Binomial smoothing along one direction: 96 rays a texel leave a little unevenness, and an
  /// even wall must stay even.
  void smooth(const Patch& patch, int count, int lines, int step, int line_step) {
    if (count < 7) return;
    std::vector<V4> copy(static_cast<std::size_t>(count));
    for (int line = 0; line < lines; ++line) {
      V4* first = &indirect_[at(patch.light_at + line * line_step)];
      for (int i = 0; i < count; ++i) copy[at(i)] = first[static_cast<std::ptrdiff_t>(i) * step];
      for (int i = 0; i < count; ++i) {
        // Beyond the border the light goes on as it comes in, so that pieces of one wall meet.
        const auto c = [&](int k) {
          if (k < 0) return splat(2.0F) * copy[0] - copy[at(-k)];
          if (k >= count) return splat(2.0F) * copy[at(count - 1)] - copy[at(2 * count - 2 - k)];
          return copy[at(k)];
        };
        first[static_cast<std::ptrdiff_t>(i) * step] =
            (c(i - 2) + c(i + 2) + splat(4.0F) * (c(i - 1) + c(i + 1)) + splat(6.0F) * c(i)) *
            splat(1.0F / 16.0F);
      }
    }
  }

  BakedLight finished() {
    BakedLight baked;
    baked.texels = direct_;
    for (std::size_t t = 0; t < direct_.size(); ++t) baked.texels[t] += indirect_[t];
    for (Patch& patch : stage_.patches) {
      for (int j = 0; j < patch.light_v; ++j) {
        for (int i = 0; i < patch.light_u; ++i) {
          const float sun = sun_near(patch, i, j);
          patch.may_see_sun = patch.may_see_sun || sun > 0.0F;
          baked.texels[at(patch.light_at + j * patch.light_u + i)][3] = sun;
        }
      }
    }
    return baked;
  }
  /// 1 where the sun reaches this texel or one beside it.
  [[nodiscard]] float sun_near(const Patch& patch, int i, int j) const {
    for (int y = std::max(0, j - 1); y <= std::min(patch.light_v - 1, j + 1); ++y) {
      for (int x = std::max(0, i - 1); x <= std::min(patch.light_u - 1, i + 1); ++x) {
        if (direct_[at(patch.light_at + y * patch.light_u + x)][3] > 0.0F) return 1.0F;
      }
    }
    return 0.0F;
  }

  static std::size_t at(int i) { return static_cast<std::size_t>(i); }

  Stage& stage_;
  const Tracer& tracer_;
  std::vector<V4> direct_;  ///< lane 3: share of the texel in the sun
  std::vector<V4> indirect_;
  std::vector<V4> radiosity_;
  std::vector<Gathered> gathered_;
  std::vector<Vec3> directions_;
};

}  // namespace

BakedLight bake_light(Stage& stage, const Tracer& tracer) {
  return Baker(stage, tracer).bake();
}

}  // namespace striate::simulator::render
