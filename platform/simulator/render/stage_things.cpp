#include <numbers>

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

struct Half {
  float x, y, z;
};
Half half_of(const ObstacleSize& size) {
  return {static_cast<float>(size.x_m) / 2.0F, static_cast<float>(size.y_m) / 2.0F,
          static_cast<float>(size.z_m)};
}

void add_table(PatchList& patches, const Stand& stand, Half h, int material) {
  const float leg = 0.055F;
  const float in = 0.03F;
  patches.block(stand, {{-h.x, -h.y, h.z - 0.035F}, {h.x, h.y, h.z}}, material, material, true);
  for (const float sx : {-1.0F, 1.0F}) {
    for (const float sy : {-1.0F, 1.0F}) {
      const float x = sx * (h.x - in - leg / 2.0F);
      const float y = sy * (h.y - in - leg / 2.0F);
      patches.block(
          stand,
          {{x - leg / 2.0F, y - leg / 2.0F, 0.0F}, {x + leg / 2.0F, y + leg / 2.0F, h.z - 0.035F}},
          material, material);
    }
  }
  for (const float s : {-1.0F, 1.0F}) {  // the apron under the top
    const float y = s * (h.y - in - leg / 2.0F);
    patches.block(
        stand,
        {{-h.x + in + leg, y - 0.012F, h.z - 0.12F}, {h.x - in - leg, y + 0.012F, h.z - 0.036F}},
        material, material, true);
    const float x = s * (h.x - in - leg / 2.0F);
    patches.block(
        stand,
        {{x - 0.012F, -h.y + in + leg, h.z - 0.12F}, {x + 0.012F, h.y - in - leg, h.z - 0.036F}},
        material, material, true);
  }
}

void add_chair(PatchList& patches, const Stand& stand, Half h, int material) {
  const int metal = patches.materials().find("metal", "chair");
  const float seat = 0.52F * h.z;
  patches.block(stand, {{-h.x + 0.03F, -h.y + 0.02F, seat - 0.05F}, {h.x, h.y - 0.02F, seat}},
                material, material, true);
  patches.block(stand, {{-h.x, -h.y + 0.03F, seat + 0.14F}, {-h.x + 0.035F, h.y - 0.03F, h.z}},
                material, material, true);
  for (const float sx : {-1.0F, 1.0F}) {
    for (const float sy : {-1.0F, 1.0F}) {
      const float x = sx * (h.x - 0.03F);
      const float y = sy * (h.y - 0.04F);
      const float top = sx < 0.0F ? h.z - 0.05F : seat - 0.05F;
      patches.column(stand, {x, y, 0.0F, top, 0.013F, 0.013F, 0.013F, 0.013F, 8, false}, metal);
    }
  }
}

void add_boxes(PatchList& patches, const Stand& stand, Half h, int material) {
  const int paint = material;
  if (h.z <= static_cast<float>(kStackAbove_m)) {
    patches.block(stand, {{-h.x, -h.y, 0.0F}, {h.x, h.y, h.z}}, paint, paint);
    return;
  }
  const float joint = 0.55F * h.z;
  patches.block(stand, {{-h.x, -h.y, 0.0F}, {h.x, h.y, joint}}, paint, paint);
  Stand turned = stand;
  turned.pose.heading_rad += 0.14;
  // Turned and yet within the footprint that the physics knows.
  const float k = 0.80F;
  patches.block(turned, {{-k * h.x, -k * h.y, joint}, {k * h.x, k * h.y, h.z}}, paint, paint);
}

void add_leaf(PatchList& patches, const Stand& stand, Half h, float pot, std::uint32_t id) {
  const int leaf = patches.materials().find("leaf", "plant");
  const float turn = 2.0F * std::numbers::pi_v<float> * uniform(mix(id));
  const float rise = 0.25F + 0.75F * uniform(mix(id, 1));
  const float reach = 0.95F - 0.45F * rise * uniform(mix(id, 2));
  const float c = std::cos(turn);
  const float s = std::sin(turn);
  const float wide = 0.035F + 0.02F * uniform(mix(id, 3));
  constexpr int kPieces = 4;                 // of a leaf's arch: enough to look bent (ours)
  const auto rib = [&](int i, float side) {  // along an arch, narrow at both ends
    const float a = static_cast<float>(i) / kPieces;
    const float out = reach * a;
    const float high = pot + (h.z - pot) * rise * (1.9F * a - 0.95F * a * a);
    const float w = side * wide * (0.25F + 3.0F * a * (1.0F - a));
    return stand.point(h.x * (c * out) - s * w, h.y * (s * out) + c * w, std::min(high, h.z));
  };
  patches.next_group();
  for (int i = 0; i < kPieces; ++i) {
    const float from = 0.06F * static_cast<float>(i);
    const float to = from + 0.06F;
    patches.quad({rib(i, -1.0F), rib(i + 1, -1.0F), rib(i + 1, 1.0F), rib(i, 1.0F)}, leaf,
                 {from, to, to, from}, {0.08F, 0.08F, 0.0F, 0.0F});
  }
}

void add_plant(PatchList& patches, const Stand& stand, Half h) {
  const int terracotta = patches.materials().find("terracotta", "plant");
  const int earth = patches.materials().find("earth", "plant");
  const float pot = 0.27F * h.z;
  const float r = 0.48F * std::min(h.x, h.y);
  patches.column(stand, {0.0F, 0.0F, 0.0F, pot, 0.7F * r, 0.7F * r, r, r, 16, false}, terracotta);
  patches.column(
      stand, {0.0F, 0.0F, pot - 0.03F, pot - 0.02F, r, r, 0.98F * r, 0.98F * r, 16, true}, earth);
  for (std::uint32_t i = 0; i < 46; ++i) add_leaf(patches, stand, h, pot - 0.03F, i);
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
