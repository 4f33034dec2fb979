#pragma once

#include "striate/platform/simulator/render/packet_kernels.hpp"
#include "striate/platform/simulator/render/people.hpp"
#include "striate/platform/simulator/render/stage.hpp"

namespace striate::simulator::render {

/// What one ray sees. Lane 3 of `colour`: weight of the mirror image that must still be added.
struct Shaded {
  V4 colour{};
  int group = 0;  ///< Patch::group; large negative where nothing was hit
};

/// Turns hits into light: texture, baked light, sun, and people's contact shadows.
class Shader {
 public:
  static constexpr int kNothing = -1000000;  ///< no material and no face has this number

  Shader(const Stage& stage, const BakedLight& baked, const PeopleOnStage& people,
         const Tracer& tracer)
      : stage_(stage), baked_(baked), people_(people), tracer_(tracer) {}

  /// `flicker`: of the lamps in this image, about 1.
  void begin_image(float flicker) { flicker_ = flicker; }

  /// Shades the valid lanes of a traced packet. `spread`: width of a pixel at distance one, grown
  /// for blurred mirror images. `before_m`: of way that the light went before (mirrors).
  void shade(const Packet& packet, float spread, const float* before_m, Shaded* out) const;

 private:
  /// What neighbouring rays on one patch have in common.
  struct Surroundings {
    const Patch* patch = nullptr;
    const Material* material = nullptr;
    /// Two mip levels a little apart, used in turn: no border is seen where the level changes.
    std::array<const Texture::Level*, 2> level{};
    PacketLight light;
    float sun = 0.0F;  ///< irradiance where it shines on the patch
    bool person = false;
  };
  /// What shading one packet passes from step to step.
  struct Lanes {
    std::array<float, Packet::kSize> sun{};
    std::array<Vec3, Packet::kSize> normal;  ///< set where the sun is
    std::array<V4, Packet::kSize> albedo;
    std::array<V4, Packet::kSize> light;
    std::array<float, Packet::kSize> mirror{};  ///< weight of the mirror image
    bool any_sun = false;
    bool people = false;  ///< any hit may lie in somebody's contact shadow
  };
  [[nodiscard]] static bool on_one_patch(const Packet& packet);
  void light_up(const Packet& packet, unsigned lane, const Surroundings& look, Lanes& lanes,
                Shaded& out) const;
  void shade_one_patch(const Packet& packet, const Surroundings& look, Lanes& lanes,
                       Shaded* out) const;
  void shade_lane(const Packet& packet, unsigned lane, const Surroundings& look, Lanes& lanes,
                  Shaded& out) const;
  [[nodiscard]] Surroundings look_at(const Packet& packet, unsigned lane, float spread,
                                     float before_m) const;
  [[nodiscard]] float hidden_by_people(Vec3 place, Vec3 normal) const;
  [[nodiscard]] bool people_near(const Packet& packet) const;
  void cast_to_sun(const Packet& packet, const std::array<Vec3, Packet::kSize>& normal,
                   std::array<float, Packet::kSize>& sun) const;

  const Stage& stage_;
  const BakedLight& baked_;
  const PeopleOnStage& people_;
  const Tracer& tracer_;
  float flicker_ = 1.0F;
};

}  // namespace striate::simulator::render
