#include <opencv2/core.hpp>

#include "striate/platform/simulator/render/paint.hpp"
#include "striate/platform/simulator/render/surface_patterns.hpp"

namespace striate::simulator::render {

const std::vector<Surface>& surfaces() {
  static const std::vector<Surface> all{
      {"plaster", 2.4, 2.4, 0.0, plaster},
      {"blank_plaster", 3.1, 3.1, 0.0, blank_plaster},
      {"brick", 1.0, 0.6, 0.0, brick},
      {"linoleum", 2.2, 2.2, 0.85, linoleum},
      {"tiles", 1.6, 1.6, 0.7, tiles},
      {"carpet", 1.0, 1.0, 0.0, carpet},
      {"wood", 1.1, 0.7, 0.12, wood},
      {"door_wood", 0.9, 1.4, 0.0, door_wood},
      {"dark_wood", 1.0, 0.8, 0.1, dark_wood},
      {"styrofoam", 0.5, 0.5, 0.0, styrofoam},
      {"concrete", 1.2, 1.2, 0.0, concrete},
      {"ceiling", 1.2, 1.2, 0.0, ceiling},
      {"wallpaper", 0.8, 0.8, 0.0, wallpaper},
      {"panelling", 1.0, 1.4, 0.0, panelling},
      {"paint_grey", 0.5, 0.5, 0.0, plain<150, 146, 142, 3>},
      {"paint_white", 0.5, 0.5, 0.0, plain<222, 224, 224, 2>},
      {"paint_green", 0.5, 0.5, 0.0, plain<92, 122, 88, 3>},
      {"paint_red", 0.5, 0.5, 0.0, plain<52, 50, 168, 3>},
      {"paint_blue", 0.5, 0.5, 0.0, plain<150, 98, 60, 3>},
      {"paint_yellow", 0.5, 0.5, 0.0, plain<56, 176, 206, 3>},
      {"paint_black", 0.5, 0.5, 0.05, plain<40, 40, 42, 4>},
      {"skirting", 0.5, 0.5, 0.0, plain<134, 130, 124, 4>},
      {"door_frame", 0.5, 0.5, 0.0, plain<164, 156, 148, 3>},
      {"metal", 0.4, 0.4, 0.15, plain<176, 176, 174, 6>},
      {"terracotta", 0.4, 0.4, 0.0, plain<70, 96, 156, 10>},
      {"skin", 0.3, 0.3, 0.0, plain<118, 140, 184, 5>},
      {"skin_dark", 0.3, 0.3, 0.0, plain<58, 76, 112, 5>},
      {"hair", 0.1, 0.1, 0.0, plain<38, 44, 52, 14>},
      {"hair_grey", 0.1, 0.1, 0.0, plain<124, 126, 128, 14>},
      {"cloth_navy", 0.4, 0.4, 0.0, woven<84, 52, 44>},
      {"cloth_blue", 0.4, 0.4, 0.0, woven<158, 104, 66>},
      {"cloth_grey", 0.4, 0.4, 0.0, woven<98, 98, 100>},
      {"cloth_black", 0.4, 0.4, 0.0, woven<38, 36, 36>},
      {"cloth_beige", 0.4, 0.4, 0.0, woven<124, 150, 168>},
      {"cloth_green", 0.4, 0.4, 0.0, woven<68, 96, 62>},
      {"cloth_red", 0.4, 0.4, 0.0, woven<54, 46, 150>},
      {"cloth_checked", 0.4, 0.4, 0.0, checked},
      {"stripes_red", 0.3, 0.3, 0.0, striped<60, 58, 186>},
      {"stripes_blue", 0.3, 0.3, 0.0, striped<146, 78, 48>},
      {"leaf", 0.25, 0.08, 0.0, leaf},
      {"earth", 0.3, 0.3, 0.0, earth},
  };
  return all;
}

}  // namespace striate::simulator::render
