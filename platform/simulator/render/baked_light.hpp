#pragma once

#include <vector>

#include "striate/platform/simulator/render/stage.hpp"
#include "striate/platform/simulator/render/tracer.hpp"

namespace striate::simulator::render {

/// Light that stands still: irradiance of the lamps and of all that reflects, in units of a bright
/// office's floor. The sun's direct light is not in it; lane 3 says where the sun may shine.
struct BakedLight {
  std::vector<V4> texels;  ///< indexed by Patch::light_at
};

/// Lights `stage`: lamps with soft shadows, sun and sky through the windows, and what walls, floor
/// and things pass on to each other (radiosity, four bounces). Also marks Patch::may_see_sun.
[[nodiscard]] BakedLight bake_light(Stage& stage, const Tracer& tracer);

/// Radiance of the lamps, times pi, that `lamp` sends to a point with a normal, unshadowed, from
/// the point `sample` of `samples` on it; with the place that it comes from.
struct LampSample {
  Vec3 from;
  float irradiance = 0.0F;
};
[[nodiscard]] LampSample lamp_sample(const Lamp& lamp, Vec3 point, Vec3 normal, int sample,
                                     int samples);

/// Directions around +z, weighted by their cosine, evenly spread.
[[nodiscard]] std::vector<Vec3> cosine_directions(int count);
/// Directions over the whole sphere, evenly spread.
[[nodiscard]] std::vector<Vec3> sphere_directions(int count);

}  // namespace striate::simulator::render
