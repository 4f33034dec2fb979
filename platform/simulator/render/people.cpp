#include "striate/platform/simulator/render/people.hpp"

#include <numbers>
#include <utility>

namespace striate::simulator::render {

/// One person being built. Own frame: x forward, y left, z up, metres of a person of 1.78 m.
class Body {
 public:
  Body(PeopleOnStage& people, const PeopleOnStage::Clothing& look, const PersonState& state,
       const LightProbes& probes, int sides)
      : people_(people), look_(look), state_(state), probes_(probes), sides_(sides) {
    stand_.pose = state.pose;
  }

  void build() {
    const auto phase = static_cast<float>(state_.stride_rad);
    const float brisk = std::min(1.0F, static_cast<float>(state_.speed_m_s) / 1.2F);
    swing_ = 0.42F * std::sqrt(std::max(0.0F, brisk));
    const float spread = swing_ * std::abs(std::sin(phase));
    hip_m_ = 0.93F - 0.86F * (1.0F - std::cos(spread)) * 0.8F;
    leg(1.0F, phase);
    leg(-1.0F, phase + std::numbers::pi_v<float>);
    trunk();
    head();
    arm(1.0F, phase + std::numbers::pi_v<float>);
    arm(-1.0F, phase);
    if (state_.carries) carry();
    shade_around();
  }

 private:
  struct Ring {
    Vec3 centre;
    Vec3 ax;  ///< half axes of the ellipse, ax x ay along the limb
    Vec3 ay;
    float along_m = 0.0F;  ///< texture coordinate
  };

  static Ring level(float x, float z, float depth, float width) {
    return {{x, 0.0F, z}, {depth, 0.0F, 0.0F}, {0.0F, width, 0.0F}, z};
  }
  /// A ring across a limb that swings in the x-z plane by `angle` from hanging straight down.
  static Ring across(Vec3 centre, float angle, float depth, float width, float along) {
    return {centre,
            {depth * std::cos(angle), 0.0F, depth * std::sin(angle)},
            {0.0F, width, 0.0F},
            along};
  }
  static Vec3 hanging(Vec3 from, float angle, float length_m) {
    return {from.x + length_m * std::sin(angle), from.y, from.z - length_m * std::cos(angle)};
  }

  [[nodiscard]] Vec3 world(Vec3 p) const {
    return stand_.point(p.x * look_.height, p.y * look_.height, p.z * look_.height);
  }

  /// A skin over rings from the bottom to the top.
  void loft(const std::vector<Ring>& rings, int material) {
    const Material& m = people_.materials_[material];
    for (std::size_t r = 0; r + 1 < rings.size(); ++r) {
      for (int i = 0; i < sides_; ++i) quad(rings[r], rings[r + 1], i, material, m);
    }
  }

  void quad(const Ring& low, const Ring& high, int i, int material, const Material& m) {
    const float step = 2.0F * std::numbers::pi_v<float> / static_cast<float>(sides_);
    const float from = step * static_cast<float>(i);
    const float to = from + step;
    Patch patch;
    const auto put = [&](std::size_t k, const Ring& ring, float angle) {
      const float c = std::cos(angle);
      const float s = std::sin(angle);
      patch.corner[k] = world(ring.centre + ring.ax * c + ring.ay * s);
      const Vec3 outward = ring.ax * (c / std::max(dot(ring.ax, ring.ax), 1e-6F)) +
                           ring.ay * (s / std::max(dot(ring.ay, ring.ay), 1e-6F));
      const Vec3 n = unit(world(ring.centre + outward) - world(ring.centre));
      patch.s[k] = angle / (2.0F * std::numbers::pi_v<float>)*2.0F;
      patch.t[k] = -ring.along_m / m.tile_y_m;
      return probes_.irradiance(patch.corner[k] + n * 0.05F, n);
    };
    const V4 l0 = put(0, low, from);
    const V4 l1 = put(1, low, to);
    const V4 l2 = put(2, high, to);
    const V4 l3 = put(3, high, from);
    patch.normal =
        unit(cross(patch.corner[2] - patch.corner[0], patch.corner[3] - patch.corner[1]));
    patch.material = material;
    patch.group = -1 - material;
    patch.texels_per_m = static_cast<float>(m.texture->height()) / m.tile_y_m;
    patch.light_at = static_cast<int>(people_.light_.size());
    patch.may_see_sun = true;
    for (V4 l : {l0, l1, l3, l2}) {
      l[3] = 1.0F;
      people_.light_.push_back(l);
    }
    people_.patches_.push_back(patch);
  }

  void leg(float side, float phase) {
    const float thigh = swing_ * std::sin(phase);
    // The knee bends while the leg comes forward.
    const float bend = 0.1F * swing_ + 1.15F * swing_ * std::max(0.0F, std::cos(phase));
    const float shin = thigh - bend;
    const Vec3 hip{0.0F, side * 0.095F, hip_m_};
    const Vec3 knee = hanging(hip, thigh, 0.43F);
    const Vec3 ankle = hanging(knee, shin, 0.41F);
    const float mid = (thigh + shin) / 2.0F;
    loft({across(ankle, shin, 0.055F, 0.05F, 0.0F),
          across(hanging(knee, shin, 0.14F), shin, 0.07F, 0.062F, 0.27F),
          across(knee, mid, 0.068F, 0.065F, 0.41F),
          across(hanging(hip, thigh, 0.16F), thigh, 0.09F, 0.085F, 0.68F),
          across(hanging(hip, thigh, -0.02F), thigh, 0.105F, 0.098F, 0.86F)},
         look_.trousers);
    const float z = std::max(0.0F, ankle.z - 0.09F);
    const auto sole = [&](float x, float h, float depth, float width) {
      return Ring{{ankle.x + x, ankle.y, z + h}, {depth, 0.0F, 0.0F}, {0.0F, width, 0.0F}, h};
    };
    loft({sole(0.05F, 0.0F, 0.145F, 0.05F), sole(0.05F, 0.035F, 0.145F, 0.05F),
          sole(0.015F, 0.075F, 0.09F, 0.045F), sole(0.0F, 0.11F, 0.05F, 0.045F)},
         look_.shoes);
    feet_.push_back({ankle.x, ankle.y, z + 0.06F});
  }

  void trunk() {
    const float h = hip_m_ - 0.93F;
    loft({level(0.0F, 0.84F + h, 0.03F, 0.03F), level(0.0F, 0.86F + h, 0.115F, 0.165F),
          level(0.0F, 0.98F + h, 0.118F, 0.17F)},
         look_.trousers);
    loft({level(0.0F, 0.95F + h, 0.124F, 0.176F), level(0.0F, 1.1F + h, 0.108F, 0.155F),
          level(0.01F, 1.25F + h, 0.125F, 0.178F), level(0.01F, 1.36F + h, 0.122F, 0.192F),
          level(0.0F, 1.43F + h, 0.105F, 0.188F), level(0.0F, 1.475F + h, 0.082F, 0.14F),
          level(0.0F, 1.505F + h, 0.06F, 0.075F), level(0.0F, 1.51F + h, 0.05F, 0.055F)},
         look_.top);
    loft({level(0.0F, 1.46F + h, 0.056F, 0.056F), level(0.015F, 1.58F + h, 0.055F, 0.055F)},
         look_.skin);
  }

  void head() {
    const float h = hip_m_ - 0.93F;
    loft({level(0.03F, 1.535F + h, 0.03F, 0.03F), level(0.03F, 1.555F + h, 0.075F, 0.06F),
          level(0.02F, 1.61F + h, 0.098F, 0.075F), level(0.02F, 1.67F + h, 0.1F, 0.08F)},
         look_.skin);
    loft({level(0.01F, 1.655F + h, 0.108F, 0.084F), level(0.008F, 1.71F + h, 0.1F, 0.08F),
          level(0.008F, 1.755F + h, 0.075F, 0.06F), level(0.008F, 1.78F + h, 0.015F, 0.015F)},
         look_.hair);
    // The back of the head.
    loft({level(-0.015F, 1.57F + h, 0.06F, 0.055F), level(-0.01F, 1.62F + h, 0.085F, 0.079F),
          level(-0.01F, 1.67F + h, 0.091F, 0.083F)},
         look_.hair);
  }

  void arm(float side, float phase) {
    // Who carries keeps his elbows back and his hands before him.
    const float upper = state_.carries ? -0.5F : 0.75F * swing_ * std::sin(phase);
    const float lower = state_.carries ? 1.3F : upper + 0.12F + 0.35F * swing_;
    const float h = hip_m_ - 0.93F;
    const Vec3 shoulder{0.0F, side * 0.19F, 1.415F + h};
    const Vec3 elbow = hanging(shoulder, upper, 0.29F) + Vec3{0.0F, side * 0.03F, 0.0F};
    const Vec3 wrist = hanging(elbow, lower, 0.25F);
    const Vec3 finger = hanging(wrist, lower, 0.17F);
    loft({across(wrist, lower, 0.032F, 0.03F, 0.0F),
          across(elbow, (upper + lower) / 2.0F, 0.044F, 0.042F, 0.25F)},
         look_.sleeves ? look_.top : look_.skin);
    loft({across(elbow, (upper + lower) / 2.0F, 0.046F, 0.044F, 0.25F),
          across(hanging(shoulder, upper, 0.06F), upper, 0.055F, 0.05F, 0.48F),
          across(hanging(shoulder, upper, 0.0F), upper, 0.05F, 0.045F, 0.55F),
          across(hanging(shoulder, upper, -0.03F), upper, 0.02F, 0.02F, 0.58F)},
         look_.top);
    loft({across(finger, lower, 0.012F, 0.01F, 0.0F),
          across(hanging(wrist, lower, 0.08F), lower, 0.042F, 0.022F, 0.08F),
          across(wrist, lower, 0.03F, 0.028F, 0.17F)},
         look_.skin);
  }

  /// A box before the chest, within the disc that a person takes of the floor.
  void carry() {
    const float h = hip_m_ - 0.93F;
    constexpr float kMiddle_m = 0.16F;
    constexpr float kDeep_m = 0.07F;  // half of it, as below: 0.14 m deep, 0.2 m wide
    constexpr float kWide_m = 0.10F;
    const auto ring = [&](float z, float share) {
      return Ring{{kMiddle_m, 0.0F, z + h},
                  {share * kDeep_m, share * kWide_m, 0.0F},
                  {-share * kDeep_m, share * kWide_m, 0.0F},
                  z};
    };
    const int sides = std::exchange(sides_, 4);
    loft({ring(1.04F, 0.05F), ring(1.04F, 1.0F), ring(1.26F, 1.0F), ring(1.26F, 0.05F)},
         people_.carton_);
    sides_ = sides;
  }

  void shade_around() {
    Occluder shadow;
    shadow.foot = world({});
    shadow.head = world({0.0F, 0.0F, 1.8F});
    shadow.balls = {{{world(feet_[0]), 0.1F},
                     {world(feet_[1]), 0.1F},
                     {world({0.0F, 0.0F, 0.45F}), 0.16F},
                     {world({0.0F, 0.0F, 0.95F}), 0.2F},
                     {world({0.0F, 0.0F, 1.3F}), 0.2F}}};
    people_.occluders_.push_back(shadow);
  }

  PeopleOnStage& people_;
  const PeopleOnStage::Clothing& look_;
  const PersonState& state_;
  const LightProbes& probes_;
  int sides_ = 12;
  Stand stand_;
  float swing_ = 0.0F;
  float hip_m_ = 0.93F;
  std::vector<Vec3> feet_;
};

PeopleOnStage::PeopleOnStage(Materials& materials) : materials_(materials) {
  struct Clothes {
    const char* top;
    const char* trousers;
    const char* shoes;
    const char* skin;
    const char* hair;
    float height;
    bool sleeves;
  };
  // As varied as people in a corridor (ours)
  static constexpr Clothes kWardrobe[kLooks] = {
      {"stripes_red", "cloth_navy", "paint_white", "skin", "hair_grey", 1.0F, true},
      {"cloth_navy", "cloth_beige", "paint_black", "skin", "hair", 1.02F, true},
      {"cloth_blue", "cloth_navy", "paint_black", "skin_dark", "hair", 0.97F, true},
      {"cloth_black", "cloth_black", "paint_black", "skin", "hair", 1.03F, true},
      {"cloth_checked", "cloth_blue", "paint_red", "skin", "hair", 0.95F, true},
      {"paint_white", "cloth_grey", "paint_black", "skin_dark", "hair", 1.0F, false},
      {"cloth_red", "cloth_black", "paint_white", "skin", "hair_grey", 0.93F, false},
      {"stripes_blue", "cloth_beige", "paint_blue", "skin", "hair", 0.99F, true},
  };
  for (const Clothes& c : kWardrobe) {
    const auto find = [&](const char* name) { return materials.find(name, "person"); };
    looks_.push_back({find(c.top), find(c.trousers), find(c.shoes), find(c.skin), find(c.hair),
                      c.height, c.sleeves});
  }
  carton_ = materials.find("cardboard", "person");
}

void PeopleOnStage::pose(const SceneState& state, const LightProbes& probes, double reach_m) {
  patches_.clear();
  light_.clear();
  occluders_.clear();
  for (const PersonState& person : state.people) {
    const double away =
        std::hypot(person.pose.x_m - state.robot.x_m, person.pose.y_m - state.robot.y_m);
    if (away > reach_m) continue;
    const auto look = static_cast<std::size_t>(((person.look % kLooks) + kLooks) % kLooks);
    Body(*this, looks_[look], person, probes, away < 3.0 ? 14 : (away < 8.0 ? 10 : 6)).build();
  }
}

}  // namespace striate::simulator::render
