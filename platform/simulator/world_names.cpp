#include "platform/simulator/world_names.hpp"

#include <fmt/ranges.h>

#include "config/quantity.hpp"
#include "platform/simulator/render/paint.hpp"

namespace striate::simulator {

namespace {

template <class Painted>
std::vector<std::string> names_of(const std::vector<Painted>& painted) {
  std::vector<std::string> names;
  names.reserve(painted.size());
  for (const Painted& one : painted) names.push_back(one.name);
  return names;
}

}  // namespace

const std::vector<std::string>& shipped_materials() {
  static const std::vector<std::string> names = names_of(render::surfaces());
  return names;
}

const std::vector<std::string>& shipped_pictures() {
  static const std::vector<std::string> names = names_of(render::pictures());
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
