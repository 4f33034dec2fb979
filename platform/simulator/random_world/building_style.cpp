#include "striate/platform/simulator/random_world/building_style.hpp"

namespace striate::simulator {

const std::vector<std::string>& building_kinds() {
  static const std::vector<std::string> names{"office", "hospital", "basement", "school",
                                              "old_house"};
  return names;
}

BuildingKind kind_of_seed(std::uint64_t seed) {
  return static_cast<BuildingKind>(seed % building_kinds().size());
}

const std::vector<std::string>& difficulty_names() {
  static const std::vector<std::string> names{
      "low_thing", "overhang",   "pinch", "dark",        "bend",  "pocket", "crowd",    "thin_pole",
      "sunlight",  "late_thing", "ring",  "side_branch", "glass", "stairs", "wet_floor"};
  return names;
}

namespace {

// Widths: accessible corridors have at least 1.50 m (DIN 18040-1), those in which beds are pushed
// 2.25 m (German rules for hospitals), those of schools 1.50 m a class and more (model rules for
// schools); cellars and old houses were built before any of them. Heights: 2.50 m and more in work
// rooms (ASR A1.2), 2.00 m under a cellar's pipes. Light: EN 12464-1 asks for 100 lx in corridors,
// 300 lx where people work; level 1 stands for the latter. Doors: 0.9 m clear and more (DIN
// 18040-1), 1.25 m where beds go through, 0.7 m in old houses. Shares, numbers of people and
// furnishings are by hand: what one meets there, and enough of each for a table.
BuildingStyle office() {
  return {{160, 240},
          {250, 300},
          {1, 3},
          {240, 400},
          {50, 100},
          {"plaster", "plaster", "wallpaper", "blank_plaster"},
          {"panelling", "brick", "paint_white", "blank_plaster"},
          {"carpet", "carpet", "linoleum"},
          {280, 600},
          {90, 100},
          35,
          10,
          {0, 2},
          {35, 45, 40, 20, 50, 15, 35, 30, 30, 25, 15, 30, 30, 15, 30}};
}
BuildingStyle hospital() {
  return {{230, 300},
          {250, 300},
          {1, 3},
          {240, 360},
          {70, 120},
          {"paint_white", "plaster", "plaster", "blank_plaster"},
          {"tiles", "paint_green", "paint_blue", "blank_plaster"},
          {"linoleum", "linoleum", "tiles"},
          {350, 700},
          {110, 130},
          30,
          10,
          {1, 3},
          {30, 40, 30, 15, 50, 15, 60, 40, 25, 30, 15, 35, 40, 15, 40}};
}
BuildingStyle basement() {
  return {{150, 220},
          {205, 240},
          {1, 2},
          {500, 900},
          {10, 40},
          {"concrete", "blank_plaster", "brick", "plaster"},
          {"concrete", "brick", "paint_grey", "blank_plaster"},
          {"concrete"},
          {500, 1200},
          {80, 100},
          5,
          0,
          {0, 1},
          {60, 30, 60, 75, 55, 25, 10, 35, 0, 25, 10, 35, 0, 30, 35}};
}
BuildingStyle school() {
  return {{250, 360},
          {300, 360},
          {1, 3},
          {300, 500},
          {60, 100},
          {"plaster", "paint_white", "brick", "tiles"},
          {"paint_yellow", "paint_green", "paint_blue", "tiles"},
          {"linoleum", "linoleum", "tiles"},
          {450, 900},
          {90, 110},
          65,
          25,
          {1, 3},
          {35, 35, 30, 15, 45, 15, 60, 25, 55, 25, 15, 30, 35, 30, 25}};
}
BuildingStyle old_house() {
  return {{130, 190},
          {260, 340},
          {1, 2},
          {350, 600},
          {20, 60},
          {"wallpaper", "wallpaper", "plaster", "panelling"},
          {"panelling", "dark_wood", "wallpaper", "blank_plaster"},
          {"wood", "wood", "carpet"},
          {300, 700},
          {70, 90},
          40,
          8,
          {0, 1},
          {45, 40, 60, 40, 60, 15, 20, 25, 30, 20, 5, 30, 10, 40, 30}};
}

}  // namespace

const BuildingStyle& style_of(BuildingKind kind) {
  // In the order of BuildingKind
  static const std::array<BuildingStyle, 5> styles{office(), hospital(), basement(), school(),
                                                   old_house()};
  return styles[static_cast<std::size_t>(kind)];
}

}  // namespace striate::simulator
