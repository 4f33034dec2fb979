#include "striate/platform/simulator/world_writer.hpp"

#include <fmt/format.h>

#include <cmath>

#include "striate/platform/simulator/world_entry.hpp"
#include "striate/platform/simulator/world_names.hpp"

namespace striate::simulator {
namespace {

std::string degrees_text(double angle_rad) {
  return fmt::format("{:g} deg", std::round(degrees(angle_rad) * 100.0) / 100.0 + 0.0);
}
std::string seconds_text(double duration_s) {
  return fmt::format("{:g} s", std::round(duration_s * 100.0) / 100.0);
}
std::string point_text(Point2 at) {
  return fmt::format("[{}, {}]", metres(at.x_m), metres(at.y_m));
}
std::string size_text(double x_m, double y_m, double z_m) {
  return fmt::format("[{}, {}, {}]", metres(x_m), metres(y_m), metres(z_m));
}
const char* side_text(Side side) {
  return side == Side::left ? "left" : "right";
}
/// A text that YAML reads back as it is.
std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? std::string("''") : std::string(1, c);
  return result + "'";
}

class WorldText {
 public:
  explicit WorldText(const World& world, const WorldNotes& notes) : world_(world), notes_(notes) {}

  std::string write() {
    comment(notes_.head);
    text_ += fmt::format("striate_world: 1\nname: {}\n", quoted(world_.name));
    text_ += fmt::format("corridor: {{length: {}, width: {}, height: {}}}\n",
                         metres(world_.length_m), metres(world_.width_m), metres(world_.height_m));
    shape();
    surfaces();
    floor();
    light();
    eyes();
    things();
    people();
    text_ += fmt::format("start: {{at: {}, heading: {}}}\n",
                         point_text({world_.start.x_m, world_.start.y_m}),
                         degrees_text(world_.start.heading_rad));
    text_ += fmt::format("goal: {{beyond: {}}}\n", metres(world_.goal_beyond_m));
    return text_;
  }

 private:
  void comment(const std::string& lines) {
    std::size_t from = 0;
    while (from < lines.size()) {
      const std::size_t end = std::min(lines.find('\n', from), lines.size());
      text_ += "# " + lines.substr(from, end - from) + "\n";
      from = end + 1;
    }
  }
  template <class Entries, class Write>
  void list(const char* key, const Entries& entries, Write write) {
    if (entries.empty()) return;
    text_ += fmt::format("{}:\n", key);
    for (const auto& entry : entries) text_ += fmt::format("  - {{{}}}\n", write(entry));
  }

  void widths(const char* key, bool wider) {
    std::vector<Widening> entries;
    for (const Widening& other : world_.widenings) {
      if ((other.width_m > world_.width_m) == wider) entries.push_back(other);
    }
    list(key, entries, [](const Widening& other) {
      return fmt::format("from: {}, to: {}, width: {}", metres(other.from_m), metres(other.to_m),
                         metres(other.width_m));
    });
  }
  void shape() {
    widths("widenings", true);
    widths("narrowings", false);
    list("turns", world_.turns, [](const Turn& turn) {
      return fmt::format("at: {}, angle: {}", metres(turn.at_m), degrees_text(turn.angle_rad));
    });
    list("pillars", world_.pillars, [](const Pillar& pillar) {
      return fmt::format("at: {}, diameter: {}", point_text(pillar.at), metres(pillar.diameter_m));
    });
  }
  void surfaces() {
    text_ += fmt::format("wall_material: {}\nfloor_material: {}\n", quoted(world_.wall_material),
                         quoted(world_.floor_material));
    list("walls", world_.walls, [](const WallStretch& wall) {
      return fmt::format("side: {}, from: {}, to: {}, material: {}", side_text(wall.side),
                         metres(wall.from_m), metres(wall.to_m), quoted(wall.material));
    });
    list("doors", world_.doors, [](const Door& door) {
      return fmt::format("side: {}, at: {}, width: {}, height: {}", side_text(door.side),
                         metres(door.at_m), metres(door.width_m), metres(door.height_m));
    });
    list("windows", world_.windows, [](const WindowRow& row) {
      return fmt::format("side: {}, from: {}, to: {}", side_text(row.side), metres(row.from_m),
                         metres(row.to_m));
    });
    list("posters", world_.posters, [](const Poster& poster) {
      return fmt::format("side: {}, at: {}, height: {}, size: [{}, {}], image: {}",
                         side_text(poster.side), metres(poster.at_m), metres(poster.height_m),
                         metres(poster.width_m), metres(poster.tall_m), quoted(poster.image));
    });
  }
  void light() {
    list("lights", world_.lights, [](const LightRow& row) {
      const std::string left = row.left_m == 0.0 ? "" : ", left: " + metres(row.left_m);
      return fmt::format("from: {}, to: {}, every: {}, level: {:g}{}", metres(row.from_m),
                         metres(row.to_m), metres(row.every_m), row.level, left);
    });
    if (!world_.sun) return;
    text_ += fmt::format("sun: {{azimuth: {}, elevation: {}, level: {:g}}}\n",
                         degrees_text(world_.sun->azimuth_rad),
                         degrees_text(world_.sun->elevation_rad), world_.sun->level);
  }
  void obstacle(const WorldObstacle& thing) {
    text_ += fmt::format("  - {{kind: {}, name: {}, at: {}",
                         obstacle_kinds()[static_cast<std::size_t>(thing.kind)], quoted(thing.name),
                         point_text(thing.at));
    if (thing.turn_rad != 0.0) text_ += ", turn: " + degrees_text(thing.turn_rad);
    if (thing.size_x_m > 0.0) {
      text_ += ", size: " + size_text(thing.size_x_m, thing.size_y_m, thing.size_z_m);
    }
    if (!thing.image.empty()) text_ += ", image: " + quoted(thing.image);
    if (thing.from_s > 0.0) text_ += ", from: " + seconds_text(thing.from_s);
    if (thing.appears_after_m > 0.0) text_ += ", appears_after: " + metres(thing.appears_after_m);
    text_ += "}\n";
  }
  void floor() {
    list("floor_patches", world_.floor_patches, [](const FloorPatch& patch) {
      return fmt::format("at: {}, turn: {}, size: [{}, {}], material: {}", point_text(patch.at),
                         degrees_text(patch.turn_rad), metres(patch.size_x_m),
                         metres(patch.size_y_m), quoted(patch.material));
    });
  }
  void eyes() {
    const EyeFaults& e = world_.eyes;
    if (e == EyeFaults{}) return;
    text_ += fmt::format(
        "eyes: {{tilt: {}, yaw: {}, focal: {:g}, baseline: {:g}, rows: {:g} px, distortion: {:g},\n"
        "       rolling_shutter: {:g} ms, white_balance: {:g}, lamp_flicker: {:g}, dirt: {:g},\n"
        "       fixed_pattern: {:g}}}\n",
        degrees_text(e.tilt_rad), degrees_text(e.yaw_rad), e.focal, e.baseline, e.rows_px,
        e.distortion, 1000.0 * e.rolling_shutter_s, e.white_balance, e.lamp_flicker, e.dirt,
        e.fixed_pattern);
  }
  void things() {
    if (!world_.obstacles.empty()) text_ += "obstacles:\n";
    for (std::size_t i = 0; i < world_.obstacles.size(); ++i) {
      const std::string note = notes_.obstacle ? notes_.obstacle(i) : "";
      if (!note.empty()) text_ += "  # " + note + "\n";
      obstacle(world_.obstacles[i]);
    }
    list("objects", world_.objects, [](const WorldObject& object) {
      std::string entry = fmt::format(
          "kind: {}, name: {}, at: {}, turn: {}", object.kind, quoted(object.name),
          size_text(object.at.x_m, object.at.y_m, object.height_m), degrees_text(object.turn_rad));
      if (object.size_x_m > 0.0) {
        entry += ", size: " + size_text(object.size_x_m, object.size_y_m, object.size_z_m);
      }
      if (!object.image.empty()) entry += ", image: " + quoted(object.image);
      return entry;
    });
  }
  void people() {
    if (world_.walks.empty() && world_.steps_in_front.empty() && world_.standers.empty()) return;
    text_ += "people:\n";
    for (const Walk& walk : world_.walks) {
      std::string points;
      for (const Point2& point : walk.points) {
        points += (points.empty() ? "" : ", ") + point_text(point);
      }
      text_ += fmt::format("  - {{walk: [{}], speed: {:g} m/s, from: {}, repeat: {}{}}}\n", points,
                           walk.speed_m_s, seconds_text(walk.from_s), walk.repeat,
                           walk.carries ? ", carries: true" : "");
    }
    for (const StepInFront& step : world_.steps_in_front) {
      text_ += fmt::format("  - {{step_in_front: {:g} per min, wait: {}}}\n", step.per_minute,
                           seconds_text(step.wait_s));
    }
    for (const Stander& stander : world_.standers) {
      text_ += fmt::format("  - {{stand: {}, heading: {}}}\n", point_text(stander.at),
                           degrees_text(stander.heading_rad));
    }
  }

  const World& world_;
  const WorldNotes& notes_;
  std::string text_;
};

}  // namespace

std::string world_as_yaml(const World& world, const WorldNotes& notes) {
  return WorldText(world, notes).write();
}

}  // namespace striate::simulator
