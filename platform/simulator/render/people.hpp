#pragma once

#include <vector>

#include "striate/platform/simulator/render/light_probes.hpp"
#include "striate/platform/simulator/scene.hpp"

namespace striate::simulator::render {

/// Keeps light from what is near, worked out from balls: a person's contact shadow.
struct Occluder {
  struct Ball {
    Vec3 centre;
    float radius_m = 0.0F;
  };
  static constexpr float kReach_m = 1.2F;  ///< beyond this, nothing is darkened
  Vec3 foot;
  Vec3 head;
  std::array<Ball, 5> balls;
};

/// The people of one image: bodies in the pose of their stride, lit by the probes.
class PeopleOnStage {
 public:
  /// Looks differ by clothes, hair, skin and height; a person's `look` is taken modulo these.
  static constexpr int kLooks = 8;

  explicit PeopleOnStage(Materials& materials);

  /// Builds those who are within `reach_m` of the viewer.
  void pose(const SceneState& state, const LightProbes& probes, double reach_m);

  [[nodiscard]] const std::vector<Patch>& patches() const { return patches_; }
  [[nodiscard]] const std::vector<V4>& light() const { return light_; }  ///< by Patch::light_at
  [[nodiscard]] const std::vector<Occluder>& occluders() const { return occluders_; }

 private:
  struct Clothing {
    int top = 0;
    int trousers = 0;
    int shoes = 0;
    int skin = 0;
    int hair = 0;
    float height = 1.0F;  ///< of 1.78 m
    bool sleeves = true;
  };
  friend class Body;

  std::vector<Clothing> looks_;
  int carton_ = 0;  ///< the material of what they carry
  const Materials& materials_;
  std::vector<Patch> patches_;
  std::vector<V4> light_;
  std::vector<Occluder> occluders_;
};

}  // namespace striate::simulator::render
