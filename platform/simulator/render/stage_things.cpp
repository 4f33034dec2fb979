#include "striate/platform/simulator/render/furniture.hpp"
#include "striate/platform/simulator/render/noise.hpp"
#include "striate/platform/simulator/render/stage.hpp"

namespace striate::simulator::render {
namespace {

/// Between places where light is baked: contact shadows on a thing show (ours)
constexpr float kThingSpacing_m = 0.09F;

Stand stand_of(Point2 at, double turn_rad, const FloorPlan& plan, double height_m = 0.0) {
  Pose2 pose = plan.at(at.x_m, at.y_m);
  pose.heading_rad += turn_rad;
  return {pose, static_cast<float>(height_m)};
}

Half half_of(const ObstacleSize& size) {
  return {static_cast<float>(size.x_m) / 2.0F, static_cast<float>(size.y_m) / 2.0F,
          static_cast<float>(size.z_m)};
}

}  // namespace

void add_obstacle(PatchList& patches, const WorldObstacle& obstacle, const FloorPlan& plan) {
  // Material of each kind of obstacle, in the order of ObstacleKind
  static constexpr const char* kOwn[] = {"wood",      "cloth_blue", "cardboard", "styrofoam",
                                         "dark_wood", "paint_red",  "leaf",      "paint_black"};
  if (obstacle.kind == ObstacleKind::wall) return add_inner_wall(patches, obstacle, plan);
  if (obstacle.kind == ObstacleKind::glass) return add_glass(patches, obstacle, plan);
  if (obstacle.kind == ObstacleKind::sitter) return add_sitter(patches, obstacle, plan);
  if (obstacle.kind == ObstacleKind::stairs) return add_stairs(patches, obstacle, plan);
  const Stand stand = stand_of(obstacle.at, obstacle.turn_rad, plan);
  const Half h = half_of(size_of(obstacle));
  const std::string name =
      obstacle.image.empty() ? kOwn[static_cast<std::size_t>(obstacle.kind)] : obstacle.image;
  const int material = patches.materials().find(name, "obstacle");
  patches.set_spacing(kThingSpacing_m);
  switch (obstacle.kind) {
    case ObstacleKind::table:
      return add_table(patches, stand, h, material);
    case ObstacleKind::chair:
      return add_chair(patches, stand, h, material);
    case ObstacleKind::cardboard_box:
      return add_boxes(patches, stand, h, material);
    case ObstacleKind::styrofoam_box:
    case ObstacleKind::box:
      return patches.block(stand, {{-h.x, -h.y, 0.0F}, {h.x, h.y, h.z}}, material, material);
    case ObstacleKind::cylinder:
      return patches.column(stand, {0.0F, 0.0F, 0.0F, h.z, h.x, h.y, h.x, h.y, 20, true}, material);
    case ObstacleKind::plant:
      return add_plant(patches, stand, h);
    case ObstacleKind::wall:
    case ObstacleKind::glass:
    case ObstacleKind::stairs:
    case ObstacleKind::sitter:
      return;  // above
    case ObstacleKind::bin:
      patches.column(stand, {0.0F, 0.0F, 0.0F, h.z, 0.8F * h.x, 0.8F * h.y, h.x, h.y, 18, false},
                     material);
      return patches.column(
          stand,
          {0.0F, 0.0F, h.z - 0.05F, h.z - 0.04F, h.x, h.y, 0.95F * h.x, 0.95F * h.y, 18, true},
          material);
  }
}

void add_object(PatchList& patches, const WorldObject& object, const FloorPlan& plan) {
  const Stand stand = stand_of(object.at, object.turn_rad, plan, object.height_m);
  const ObstacleSize size = size_of(object);
  const Half h = half_of(size);
  patches.set_spacing(0.06F);
  if (object.kind == "cup") {
    const int material =
        patches.materials().find(object.image.empty() ? "cup_dots" : object.image, "object");
    patches.column(stand, {0.0F, 0.0F, 0.0F, h.z, 0.85F * h.x, 0.85F * h.y, h.x, h.y, 18, true},
                   material);
    const int white = patches.materials().find("paint_white", "object");
    patches.block(stand, {{h.x * 0.9F, -0.006F, 0.25F * h.z}, {h.x * 1.5F, 0.006F, 0.8F * h.z}},
                  white, white, true);
    return;
  }
  const std::string own = object.kind == "book" ? "book_red" : "box_tea";
  const int material =
      patches.materials().find(object.image.empty() ? own : object.image, "object");
  patches.block(stand, {{-h.x, -h.y, 0.0F}, {h.x, h.y, h.z}}, material, material);
}

void add_pillar(PatchList& patches, const Pillar& pillar, const World& world,
                const FloorPlan& plan) {
  const Stand stand = stand_of(pillar.at, 0.0, plan);
  const int material = patches.materials().find("plaster", "pillar");
  const auto top = static_cast<float>(world.height_m);
  const float r = static_cast<float>(pillar.diameter_m) / 2.0F;
  constexpr int kSides = 28;  // of a pillar: its outline errs by 0.6 % of the radius
  patches.set_spacing(0.12F);
  patches.column(
      stand,
      {0.0F, 0.0F, 0.1F, top - 0.1F, 0.92F * r, 0.92F * r, 0.92F * r, 0.92F * r, kSides, false},
      material);
  const int foot = patches.materials().find("skirting", "pillar");
  patches.column(stand, {0.0F, 0.0F, 0.0F, 0.1F, r, r, r, r, kSides, true}, foot);
  patches.column(stand, {0.0F, 0.0F, top - 0.1F, top, 0.92F * r, 0.92F * r, r, r, kSides, false},
                 material);
}

void add_door(PatchList& patches, const Stand& wall, float middle_m, const Door& door, int number) {
  // Materials of door leaves, in turn
  static constexpr const char* kLeaves[] = {"door_wood", "door_wood", "dark_wood", "door_wood",
                                            "paint_blue"};
  const int leaf = patches.materials().find(kLeaves[number % 5], "door");
  const int frame = patches.materials().find("door_frame", "door");
  const int metal = patches.materials().find("metal", "door");
  const float half = static_cast<float>(door.width_m) / 2.0F;
  const auto top = static_cast<float>(door.height_m);
  const auto block = [&](Vec3 low, Vec3 high, int material) {
    patches.block(wall, {{middle_m + low.x, low.y, low.z}, {middle_m + high.x, high.y, high.z}},
                  material, material, low.z > 0.3F);
  };
  patches.set_spacing(0.2F);
  block({-half, 0.0F, 0.005F}, {half, 0.008F, top}, leaf);
  block({-half - 0.07F, 0.0F, 0.0F}, {-half, 0.026F, top}, frame);
  block({half, 0.0F, 0.0F}, {half + 0.07F, 0.026F, top}, frame);
  block({-half - 0.07F, 0.0F, top}, {half + 0.07F, 0.026F, top + 0.07F}, frame);
  const float lock = number % 2 == 0 ? half - 0.08F : -half + 0.08F;
  const float inward = number % 2 == 0 ? -1.0F : 1.0F;
  block({lock - 0.02F, 0.008F, 0.92F}, {lock + 0.02F, 0.014F, 1.12F}, metal);
  block({std::min(lock, lock + inward * 0.13F), 0.045F, 1.03F},
        {std::max(lock, lock + inward * 0.13F), 0.065F, 1.05F}, metal);
  block({lock - 0.01F, 0.008F, 1.03F}, {lock + 0.01F, 0.05F, 1.05F}, metal);
  // The room's name plate beside it.
  const int plate = patches.materials().find("poster_plate", "door");
  const float beside = lock > 0.0F ? half + 0.2F : -half - 0.2F;
  block({beside - 0.08F, 0.0F, 1.45F}, {beside + 0.08F, 0.008F, 1.57F}, plate);
}

}  // namespace striate::simulator::render
