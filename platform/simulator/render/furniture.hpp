#pragma once

#include "striate/platform/simulator/render/stage.hpp"

/// Furniture, plants and boxes of a stage.
namespace striate::simulator::render {

/// Of a thing: half its width and depth, and its whole height, in m.
struct Half {
  float x, y, z;
};

void add_table(PatchList& patches, const Stand& stand, Half h, int material);

void add_chair(PatchList& patches, const Stand& stand, Half h, int material);

void add_boxes(PatchList& patches, const Stand& stand, Half h, int material);

void add_plant(PatchList& patches, const Stand& stand, Half h);

}  // namespace striate::simulator::render
