#pragma once

#include <string>

#include "striate/config/map_reader.hpp"
#include "striate/platform/simulator/world.hpp"

/// Shared by the files that read parts of a world: one entry of a list and its checks.
namespace striate::simulator {

/// One entry of a list of a world file ("a door"), with the checks that many kinds share. The
/// checks speak only while the entry has no other mistake, so that one slip is told once.
class WorldEntry {
 public:
  WorldEntry(const config::Node& node, const std::string& what, const World& world,
             config::Diagnostics& diagnostics);

  [[nodiscard]] config::MapReader& map() { return map_; }
  /// No mistake so far in this entry.
  [[nodiscard]] bool sound() const { return diagnostics_.list().size() == before_; }
  void add(const std::string& key, const std::string& message, const std::string& hint = {});

  void require_side(Side& side);
  void require_length(const std::string& key, double& target, config::Range range);
  void require_point(const std::string& key, Point2& target);
  void require_stretch(double& from_m, double& to_m);
  /// Says so where `along_m` is no place of the corridor.
  void check_along(const std::string& key, double along_m);
  /// Says so where a disc of `radius_m` does not stand free of the walls.
  void check_inside(const std::string& key, Point2 at, double radius_m = 0.0);
  /// Checks that `image` is one of the shipped names or a readable file, whose path it completes.
  void check_image(const std::string& key, std::string& image,
                   const std::vector<std::string>& shipped);
  /// Reads the rest: unknown keys.
  void finish() { map_.finish(); }

 private:
  const World& world_;
  config::Diagnostics& diagnostics_;
  std::size_t before_;
  config::MapReader map_;
};

/// "12.3 m": lengths in messages.
[[nodiscard]] std::string metres(double length_m);

/// Calls `read(node)` for every item of the list `key`; a value that is no list is a mistake.
template <class Read>
void for_each_entry(config::MapReader& root, const std::string& key, Read read) {
  const config::Node* list = root.raw(key);
  if (list == nullptr) return;
  if (list->kind != config::Node::Kind::list) {
    root.diagnostics().add(list->place, "'" + key + "' must be a list, not " + list->describe(),
                           "write each entry on a line of its own that begins with '- '");
    return;
  }
  for (const config::Node& item : list->items) read(item);
}

/// The parts of a world, in the order in which they build on one another.
void read_corridor(config::MapReader& root, World& world);
void read_walls(config::MapReader& root, World& world);
void read_lights(config::MapReader& root, World& world);
void read_things(config::MapReader& root, World& world);
void read_people(config::MapReader& root, World& world);

}  // namespace striate::simulator
