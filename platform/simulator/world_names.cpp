#include "platform/simulator/world_names.hpp"

#include <fmt/ranges.h>

#include "config/quantity.hpp"

namespace striate::simulator {

const std::vector<std::string>& wall_materials() {
  static const std::vector<std::string> names{"plaster", "blank_plaster", "brick"};
  return names;
}

const std::vector<std::string>& floor_materials() {
  static const std::vector<std::string> names{"linoleum"};
  return names;
}

const std::vector<std::string>& shipped_pictures() {
  static const std::vector<std::string> names{"poster_fish"};
  return names;
}

const std::vector<std::string>& obstacle_kinds() {
  static const std::vector<std::string> names{"table", "chair",    "cardboard_box", "styrofoam_box",
                                              "box",   "cylinder", "plant",         "bin"};
  return names;
}

const std::vector<std::string>& object_kinds() {
  static const std::vector<std::string> names{"box", "book", "cup"};
  return names;
}

std::string suggestion(const std::string& wrong, const std::vector<std::string>& names) {
  std::string near = config::suggest(wrong, names);
  return near.empty() ? fmt::format("there are: {}", fmt::join(names, ", ")) : near;
}

}  // namespace striate::simulator
