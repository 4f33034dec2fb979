#include "striate/platform/simulator/world_names.hpp"

#include <fmt/ranges.h>

#include "striate/config/quantity.hpp"
#include "striate/platform/simulator/render/paint.hpp"

namespace striate::simulator {

std::vector<std::string> surface_names() {
  std::vector<std::string> names;
  for (const render::Surface& surface : render::surfaces()) names.push_back(surface.name);
  return names;
}

std::vector<std::string> picture_names() {
  std::vector<std::string> names;
  for (const render::Picture& picture : render::pictures()) names.push_back(picture.name);
  return names;
}

const std::vector<std::string>& obstacle_kinds() {
  static const std::vector<std::string> names{"table", "chair",    "cardboard_box", "styrofoam_box",
                                              "box",   "cylinder", "plant",         "bin",
                                              "wall",  "glass",    "stairs",        "sitter"};
  return names;
}

const std::vector<std::string>& object_kinds() {
  static const std::vector<std::string> names{"box", "book", "cup"};
  return names;
}

std::string suggestion(const std::string& wrong, const std::vector<std::string>& names) {
  std::string near = config::suggest(wrong, names);
  if (near.empty() && names.size() > 20) return "the README of config/worlds lists the names";
  return near.empty() ? fmt::format("there are: {}", fmt::join(names, ", ")) : near;
}

}  // namespace striate::simulator
