#pragma once

#include <array>
#include <vector>

#include "striate/platform/simulator/render/baked_light.hpp"

namespace striate::simulator::render {

/// Baked light in the free space of the corridor, for what moves: at each place of a grid the
/// irradiance from six sides.
class LightProbes {
 public:
  LightProbes(const Stage& stage, const FloorPlan& plan, const BakedLight& baked,
              const Tracer& tracer);
  /// Irradiance at a point on a face with this normal.
  [[nodiscard]] V4 irradiance(Vec3 point, Vec3 normal) const;

 private:
  static constexpr int kHeights = 3;  ///< as many as kHeight_m in light_probes.cpp
  /// Three across the 2.4 m of a corridor: shadows of lamps are wider (ours)
  static constexpr float kCell_m = 0.75F;
  struct Probe {
    bool inside = false;
    std::array<std::array<V4, 6>, kHeights> light{};  ///< from +x, -x, +y, -y, +z, -z
  };
  [[nodiscard]] std::array<V4, 6> measure(const Stage& stage, const BakedLight& baked,
                                          const Tracer& tracer, Vec3 point) const;
  [[nodiscard]] const Probe* at(int i, int j) const;

  float x0_m_ = 0.0F;
  float y0_m_ = 0.0F;
  int columns_ = 0;
  int rows_ = 0;
  std::vector<Vec3> directions_;
  std::vector<Probe> probes_;
};

}  // namespace striate::simulator::render
