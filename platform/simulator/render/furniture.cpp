#include "striate/platform/simulator/render/furniture.hpp"

#include <numbers>

#include "striate/platform/simulator/render/noise.hpp"

namespace striate::simulator::render {
namespace {

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

}  // namespace

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

}  // namespace striate::simulator::render
