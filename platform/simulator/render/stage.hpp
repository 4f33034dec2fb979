#pragma once

#include <optional>
#include <vector>

#include "striate/platform/simulator/obstacle_shapes.hpp"
#include "striate/platform/simulator/render/outdoors.hpp"
#include "striate/platform/simulator/render/patches.hpp"
#include "striate/platform/simulator/scene.hpp"
#include "striate/platform/simulator/world.hpp"

namespace striate::simulator::render {

/// A flat source: a fluorescent panel under the ceiling, or a window that lets the sky in.
struct Lamp {
  Vec3 centre;
  Vec3 along;   ///< half its length
  Vec3 across;  ///< half its width
  float exitance = 0.0F;
  Vec3 facing{0.0F, 0.0F, -1.0F};  ///< unit vector

  [[nodiscard]] float area_m2() const { return 4.0F * length(along) * length(across); }
};

struct SunLight {
  Vec3 towards;  ///< unit vector to the sun
  float irradiance = 0.0F;
};

/// Everything that stands still, before it is lit. Light is in units of the irradiance on the
/// floor of a bright office corridor.
struct Stage {
  Materials materials;
  std::vector<Patch> patches;
  int light_texels = 0;
  std::vector<Lamp> lamps;
  std::vector<Lamp> windows;
  std::optional<SunLight> sun;
  Outdoors outdoors;
  float sky = 0.0F;  ///< brightness of the view through the windows
};

/// Throws UserError for a material that is neither shipped nor a file.
[[nodiscard]] Stage build_stage(const World& world, const FloorPlan& plan);

// The parts of it, each in its own file.
void add_floor_and_ceiling(PatchList& patches, const World& world, const FloorPlan& plan);
void add_walls(PatchList& patches, std::vector<Lamp>& windows, const World& world,
               const FloorPlan& plan);
void add_door(PatchList& patches, const Stand& wall, float middle_m, const Door& door, int number);
void add_pillar(PatchList& patches, const Pillar& pillar, const World& world,
                const FloorPlan& plan);
void add_lamps(PatchList& patches, std::vector<Lamp>& lamps, const World& world,
               const FloorPlan& plan);
void add_obstacle(PatchList& patches, const WorldObstacle& obstacle, const FloorPlan& plan);
/// Walls within the corridor, panes of glass, stairs that go down: each as `obstacle` is.
void add_inner_wall(PatchList& patches, const WorldObstacle& obstacle, const FloorPlan& plan);
void add_glass(PatchList& patches, const WorldObstacle& obstacle, const FloorPlan& plan);
void add_stairs(PatchList& patches, const WorldObstacle& obstacle, const FloorPlan& plan);
void add_sitter(PatchList& patches, const WorldObstacle& obstacle, const FloorPlan& plan);
void add_floor_patch(PatchList& patches, const FloorPatch& patch, const World& world,
                     const FloorPlan& plan);
void add_object(PatchList& patches, const WorldObject& object, const FloorPlan& plan);

}  // namespace striate::simulator::render
