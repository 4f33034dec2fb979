#include "striate/platform/simulator/world_entry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <opencv2/imgcodecs.hpp>

#include "striate/platform/simulator/corridor_width.hpp"
#include "striate/platform/simulator/world_names.hpp"

namespace striate::simulator {

using config::SourceLocation;
using config::Unit;

std::string metres(double length_m) {
  return fmt::format("{:g} m", std::round(length_m * 1000) / 1000 + 0.0);  // no -0
}

WorldEntry::WorldEntry(const config::Node& node, const std::string& what, const World& world,
                       config::Diagnostics& diagnostics)
    : world_(world),
      diagnostics_(diagnostics),
      before_(diagnostics.list().size()),
      map_(node, what, diagnostics) {}

void WorldEntry::add(const std::string& key, const std::string& message, const std::string& hint) {
  const auto* entry = map_.node().find(key);
  diagnostics_.add(entry != nullptr ? entry->value.place : map_.node().place, message, hint);
}

void WorldEntry::require_side(Side& side) {
  int index = static_cast<int>(side);
  if (map_.require("side")) map_.choice("side", index, {"left", "right"});
  side = static_cast<Side>(index);
}

void WorldEntry::require_length(const std::string& key, double& target, config::Range range) {
  if (map_.require(key)) map_.number(key, target, Unit::length, range);
}

void WorldEntry::require_point(const std::string& key, Point2& target) {
  if (!map_.require(key)) return;
  map_.numbers(key, {&target.x_m, &target.y_m}, Unit::length, {-1000.0, 1000.0});
}

void WorldEntry::require_stretch(double& from_m, double& to_m) {
  require_length("from", from_m, {-1000.0, 1000.0});
  require_length("to", to_m, {-1000.0, 1000.0});
  if (!sound()) return;
  check_along("from", from_m);
  check_along("to", to_m);
  if (sound() && from_m >= to_m) {
    add("to", fmt::format("'to' ({}) must lie beyond 'from' ({})", metres(to_m), metres(from_m)));
  }
}

void WorldEntry::check_along(const std::string& key, double along_m) {
  if (along_m >= 0.0 && along_m <= world_.length_m) return;
  add(key, fmt::format("'{}' ({}) lies outside the corridor", key, metres(along_m)),
      fmt::format("the corridor goes from 0 m to {}", metres(world_.length_m)));
}

void WorldEntry::check_inside(const std::string& key, Point2 at, double radius_m) {
  if (!sound()) return;
  if (at.x_m - radius_m < 0.0 || at.x_m + radius_m > world_.length_m) {
    add(key, fmt::format("x = {} lies outside the corridor", metres(at.x_m)),
        fmt::format("the corridor goes from 0 m to {}", metres(world_.length_m)));
    return;
  }
  const double half =
      std::min({half_width_m(world_, at.x_m - radius_m), half_width_m(world_, at.x_m + radius_m),
                half_width_m(world_, at.x_m)});
  if (std::abs(at.y_m) + radius_m > half) {
    add(key, fmt::format("y = {} lies outside the corridor", metres(at.y_m)),
        fmt::format("the walls stand at {} and {} there", metres(-half), metres(half)));
  }
}

void WorldEntry::check_image(const std::string& key, std::string& image,
                             const std::vector<std::string>& shipped) {
  if (!sound() || std::find(shipped.begin(), shipped.end(), image) != shipped.end()) return;
  if (image.find_first_of("./") == std::string::npos) {
    add(key, fmt::format("nothing that ships is called '{}'", image), suggestion(image, shipped));
    return;
  }
  const std::filesystem::path path =
      std::filesystem::path(world_.file).parent_path() / std::filesystem::path(image);
  const std::string file = path.lexically_normal().string();
  if (!std::filesystem::is_regular_file(path)) {
    add(key, fmt::format("there is no file '{}'", file),
        "the path counts from the world file's folder");
  } else if (!cv::haveImageReader(file)) {
    add(key, fmt::format("'{}' is no image that can be read", file), "use PNG or JPEG");
  }
  image = file;
}

}  // namespace striate::simulator
