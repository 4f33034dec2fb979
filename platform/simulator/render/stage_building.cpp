#include <algorithm>
#include <cmath>

#include "striate/platform/simulator/render/stage.hpp"
#include "striate/platform/simulator/world_names.hpp"

/// What a building is made of beside its outer walls: inner walls, glass, stairs, what lies flat.
namespace striate::simulator::render {
namespace {

Stand stand_in_plan(Point2 at, double turn_rad, const FloorPlan& plan) {
  Pose2 pose = plan.at(at.x_m, at.y_m);
  pose.heading_rad += turn_rad;
  return {pose, 0.0F};
}

Vec3 between(const Stand& stand, Vec3 from, Vec3 to) {
  return stand.point(to.x, to.y, to.z) - stand.point(from.x, from.y, from.z);
}

/// A rectangle in a stand's frame; it is lit from where `along` x `up` points.
void flat(PatchList& patches, const Stand& stand, Vec3 corner, Vec3 along, Vec3 up, int material) {
  patches.next_group();
  patches.rectangle(stand.point(corner.x, corner.y, corner.z),
                    between(stand, corner, corner + along), between(stand, corner, corner + up),
                    material);
}

}  // namespace

void add_inner_wall(PatchList& patches, const WorldObstacle& obstacle, const FloorPlan& plan) {
  const Stand stand = stand_in_plan(obstacle.at, obstacle.turn_rad, plan);
  const ObstacleSize size = size_of(obstacle);
  const auto x = static_cast<float>(size.x_m / 2.0);
  const auto y = static_cast<float>(size.y_m / 2.0);
  const int material =
      patches.materials().find(obstacle.image.empty() ? "plaster" : obstacle.image, "inner wall");
  patches.set_spacing(0.15F);
  patches.block(stand, {{-x, -y, 0.0F}, {x, y, static_cast<float>(plan.height_m)}}, material,
                material);
}

/// The frame alone is drawn. The pane is as clear as clean glass is; it mirrors nothing.
void add_glass(PatchList& patches, const WorldObstacle& obstacle, const FloorPlan& plan) {
  const Stand stand = stand_in_plan(obstacle.at, obstacle.turn_rad, plan);
  const ObstacleSize size = size_of(obstacle);
  const auto x = static_cast<float>(size.x_m / 2.0);
  const auto y = static_cast<float>(size.y_m / 2.0);
  const auto z = static_cast<float>(size.z_m);
  const auto post = static_cast<float>(kGlassPost_m);
  const int frame =
      patches.materials().find(obstacle.image.empty() ? "metal" : obstacle.image, "glass door");
  patches.set_spacing(0.2F);
  const auto bar = [&](Vec3 low, Vec3 high) {
    patches.block(stand, {low, high}, frame, frame, true);
  };
  bar({-x, -y, 0.0F}, {-x + post, y, z});
  bar({x - post, -y, 0.0F}, {x, y, z});
  bar({-x + post, -y, z - 0.06F}, {x - post, y, z});
  bar({-x + post, -y, 0.005F}, {x - post, y, 0.09F});
  // A handle at the height of a hand, 1.05 m (DIN 18040-1: 0.85 m to 1.05 m)
  if (z > 1.2F) bar({x - 0.2F, -y - 0.03F, 1.03F}, {x - post, y + 0.03F, 1.06F});
}

/// A flight that goes down along x through a hole in the floor, between two walls.
void add_stairs(PatchList& patches, const WorldObstacle& obstacle, const FloorPlan& plan) {
  constexpr float kRise_m = 0.175F;  // a comfortable step (DIN 18065: 14 cm to 20 cm)
  const Stand stand = stand_in_plan(obstacle.at, obstacle.turn_rad, plan);
  const ObstacleSize size = size_of(obstacle);
  const auto x = static_cast<float>(size.x_m / 2.0);
  const auto y = static_cast<float>(size.y_m / 2.0);
  const auto deep = static_cast<float>(size.z_m);
  const int steps = std::max(1, static_cast<int>(std::lround(deep / kRise_m)));
  const float rise = deep / static_cast<float>(steps);
  const float tread = 2.0F * x / static_cast<float>(steps);
  const int stone =
      patches.materials().find(obstacle.image.empty() ? "concrete" : obstacle.image, "stairs");
  const int wall = patches.materials().find("plaster", "stairs");
  patches.set_spacing(0.1F);
  for (int i = 0; i < steps; ++i) {
    const float from = -x + tread * static_cast<float>(i);
    const float low = -rise * static_cast<float>(i + 1);
    flat(patches, stand, {from, -y, low}, {0.0F, 2.0F * y, 0.0F}, {0.0F, 0.0F, rise}, stone);
    flat(patches, stand, {from, -y, low}, {tread, 0.0F, 0.0F}, {0.0F, 2.0F * y, 0.0F}, stone);
  }
  const Vec3 up{0.0F, 0.0F, deep};
  flat(patches, stand, {-x, y, -deep}, {2.0F * x, 0.0F, 0.0F}, up, wall);
  flat(patches, stand, {x, -y, -deep}, {-2.0F * x, 0.0F, 0.0F}, up, wall);
  flat(patches, stand, {x, y, -deep}, {0.0F, -2.0F * y, 0.0F}, up, wall);
}

/// A person on a chair, in shares of the whole size: back at the back, shins at the front.
void add_sitter(PatchList& patches, const WorldObstacle& obstacle, const FloorPlan& plan) {
  const Stand stand = stand_in_plan(obstacle.at, obstacle.turn_rad, plan);
  const ObstacleSize size = size_of(obstacle);
  const auto x = [&](double share) { return static_cast<float>(share * size.x_m); };
  const auto y = [&](double share) { return static_cast<float>(share * size.y_m); };
  const auto z = [&](double share) { return static_cast<float>(share * size.z_m); };
  const auto find = [&](const std::string& name) {
    return patches.materials().find(name, "sitter");
  };
  const int top = find(obstacle.image.empty() ? "cloth_red" : obstacle.image);
  const int trousers = find("cloth_navy");
  const int metal = find("metal");
  const int wood = find("wood");
  const auto block = [&](Vec3 low, Vec3 high, int material) {
    patches.block(stand, {low, high}, material, material, true);
  };
  patches.set_spacing(0.09F);
  block({x(-0.5), y(-0.42), z(0.33)}, {x(0.1), y(0.42), z(0.36)}, wood);    // seat
  block({x(-0.5), y(-0.42), z(0.45)}, {x(-0.46), y(0.42), z(0.68)}, wood);  // back
  for (const double side : {-1.0, 1.0}) {
    for (const double along : {-0.45, 0.05}) {
      patches.column(
          stand, {x(along), y(0.4 * side), 0.0F, z(0.33), 0.013F, 0.013F, 0.013F, 0.013F, 8, false},
          metal);
    }
    const float low = y(0.23 * side) - 0.055F;
    const float high = y(0.23 * side) + 0.055F;
    block({x(-0.3), low, z(0.36)}, {x(0.47), high, z(0.47)}, trousers);                  // thigh
    block({x(0.4) - 0.055F, low, z(0.05)}, {x(0.4) + 0.055F, high, z(0.37)}, trousers);  // shin
    block({x(0.4) - 0.07F, low, 0.0F}, {x(0.5), high, z(0.06)}, find("paint_black"));    // shoe
    patches.column(
        stand, {x(-0.2), y(0.43 * side), z(0.46), z(0.8), 0.045F, 0.04F, 0.05F, 0.045F, 10, true},
        top);  // upper arm
  }
  patches.column(stand, {x(-0.28), 0.0F, z(0.4), z(0.82), 0.115F, y(0.34), 0.1F, y(0.38), 16, true},
                 top);
  const int skin = find("skin");
  patches.column(stand,
                 {x(-0.26), 0.0F, z(0.81), z(0.87), 0.055F, 0.055F, 0.055F, 0.055F, 12, false},
                 skin);  // neck
  patches.column(stand, {x(-0.26), 0.0F, z(0.86), z(0.96), 0.075F, 0.06F, 0.1F, 0.08F, 14, true},
                 skin);
  patches.column(stand, {x(-0.27), 0.0F, z(0.95), z(1.0), 0.1F, 0.08F, 0.06F, 0.05F, 14, true},
                 find("hair"));
}

void add_floor_patch(PatchList& patches, const FloorPatch& patch, const World& world,
                     const FloorPlan& plan) {
  constexpr float kThick_m = 0.004F;  // of a carpet; enough that the floor does not shine through
  const Stand stand = stand_in_plan(patch.at, patch.turn_rad, plan);
  const auto x = static_cast<float>(patch.size_x_m / 2.0);
  const auto y = static_cast<float>(patch.size_y_m / 2.0);
  const int material = patch.material == kWet
                           ? patches.materials().wet(world.floor_material)
                           : patches.materials().find(patch.material, "floor patch");
  patches.set_spacing(0.1F);
  flat(patches, stand, {-x, -y, kThick_m}, {2.0F * x, 0.0F, 0.0F}, {0.0F, 2.0F * y, 0.0F},
       material);
}

}  // namespace striate::simulator::render
