#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <filesystem>
#include <limits>

#include "striate/platform/simulator/obstacle_shapes.hpp"
#include "striate/platform/simulator/scene.hpp"
#include "striate/platform/simulator/world_reader.hpp"

namespace striate::simulator {
namespace {

std::vector<std::string> shipped_files() {
  std::vector<std::string> files;
  for (const auto& file :
       std::filesystem::directory_iterator(STRIATE_SOURCE_DIR "/config/worlds")) {
    if (file.path().extension() == ".yaml") files.push_back(file.path().string());
  }
  std::sort(files.begin(), files.end());
  return files;
}

TEST(ShippedWorlds, LoadWithoutADiagnostic) {
  EXPECT_GE(shipped_files().size(), 5u);
  for (const std::string& file : shipped_files()) {
    config::Diagnostics diagnostics(file);
    const World world = read_world(diagnostics);
    EXPECT_TRUE(diagnostics.none()) << diagnostics.text();
    EXPECT_EQ(world.name, std::filesystem::path(file).stem().string());
  }
}

/// Written apart from the simulator's own geometry on purpose: it judges that.
class Passage {
 public:
  explicit Passage(const World& world) : plan_(build_floor_plan(world)) {
    for (const Pillar& pillar : world.pillars) {
      const Pose2 at = plan_.at(pillar.at.x_m, pillar.at.y_m);
      round_.push_back({{at.x_m, at.y_m}, pillar.diameter_m / 2});
    }
    for (const Stander& stander : world.standers) {
      const Pose2 at = plan_.at(stander.at.x_m, stander.at.y_m);
      round_.push_back({{at.x_m, at.y_m}, kPersonRadius_m});
    }
    for (const WorldObstacle& obstacle : world.obstacles) {
      Pose2 pose = plan_.at(obstacle.at.x_m, obstacle.at.y_m);
      pose.heading_rad += obstacle.turn_rad;
      for (const Footprint& polygon : footprint(obstacle)) {
        std::vector<Point2> corners;
        for (const Point2& corner : polygon) corners.push_back(transform(pose, corner));
        polygons_.push_back(corners);
      }
    }
  }

  /// Whether a disc of this width can roll from start to goal.
  [[nodiscard]] bool rolls_through(const World& world, double width_m) const {
    const double radius_m = width_m / 2;
    const Pose2 start = plan_.at(world.start.x_m, world.start.y_m);
    const int columns = 2 + static_cast<int>(world.length_m / kCell_m);
    const int rows = 2 + static_cast<int>(12.0 / kCell_m);
    const auto place = [&](int column, int row) {
      return Point2{column * kCell_m, (row - rows / 2) * kCell_m};
    };
    std::vector<char> seen(static_cast<std::size_t>(columns * rows), 0);
    std::deque<std::pair<int, int>> open;
    // Rolls on from the first free place before the start: the start wall may be near.
    for (int column = static_cast<int>(start.x_m / kCell_m); column < columns; ++column) {
      const int row = rows / 2 + static_cast<int>(std::lround(start.y_m / kCell_m));
      if (!free(place(column, row), radius_m)) continue;
      open.emplace_back(column, row);
      break;
    }
    while (!open.empty()) {
      const auto [column, row] = open.front();
      open.pop_front();
      if (column < 0 || row < 0 || column >= columns || row >= rows) continue;
      char& mark = seen[static_cast<std::size_t>(row * columns + column)];
      if (mark != 0) continue;
      mark = 1;
      if (!free(place(column, row), radius_m)) continue;
      if (place(column, row).x_m >= world.goal_beyond_m - radius_m) return true;
      for (const auto& [dx, dy] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
        open.emplace_back(column + dx, row + dy);
      }
    }
    return false;
  }

 private:
  struct Round {
    Point2 at;
    double radius_m;
  };
  static constexpr double kCell_m = 0.04;

  static double to_line_m(Point2 p, Point2 a, Point2 b) {
    const double dx = b.x_m - a.x_m;
    const double dy = b.y_m - a.y_m;
    const double t =
        std::clamp(((p.x_m - a.x_m) * dx + (p.y_m - a.y_m) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
    return std::hypot(a.x_m + t * dx - p.x_m, a.y_m + t * dy - p.y_m);
  }
  static double to_polygon_m(Point2 p, const std::vector<Point2>& corners) {
    double nearest = std::numeric_limits<double>::infinity();
    bool inside = true;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Point2& a = corners[i];
      const Point2& b = corners[(i + 1) % corners.size()];
      nearest = std::min(nearest, to_line_m(p, a, b));
      inside =
          inside && (b.x_m - a.x_m) * (p.y_m - a.y_m) - (b.y_m - a.y_m) * (p.x_m - a.x_m) >= 0.0;
    }
    return inside ? 0.0 : nearest;
  }
  [[nodiscard]] bool free(Point2 p, double radius_m) const {
    for (const WallSegment& wall : plan_.walls) {
      if (to_line_m(p, wall.from, wall.to) < radius_m) return false;
    }
    for (const Round& thing : round_) {
      if (std::hypot(p.x_m - thing.at.x_m, p.y_m - thing.at.y_m) < thing.radius_m + radius_m) {
        return false;
      }
    }
    return std::none_of(polygons_.begin(), polygons_.end(),
                        [&](const auto& polygon) { return to_polygon_m(p, polygon) < radius_m; });
  }

  FloorPlan plan_;
  std::vector<Round> round_;
  std::vector<std::vector<Point2>> polygons_;
};

/// Narrow places are what that world is for.
double way_through_m(const std::string& file) {
  return file.find("hard_narrow") == std::string::npos ? 0.95 : 0.75;
}

TEST(ShippedWorlds, LeaveAWayFromStartToGoal) {
  for (const std::string& file : shipped_files()) {
    const World world = load_world(file);
    if (!world.turns.empty()) continue;  // the flood is for straight corridors
    EXPECT_TRUE(Passage(world).rolls_through(world, way_through_m(file))) << file;
  }
}

TEST(ShippedWorlds, ThePassageTestSeesABlockedCorridor) {
  World world = load_world(STRIATE_SOURCE_DIR "/config/worlds/short.yaml");
  WorldObstacle table;
  table.kind = ObstacleKind::table;
  table.at = {9.0, 0.0};
  table.turn_rad = radians(90.0);
  world.obstacles.push_back(table);
  EXPECT_TRUE(Passage(world).rolls_through(world, 0.55));
  EXPECT_FALSE(Passage(world).rolls_through(world, 0.65)) << "the table leaves 0.6 m";
}

TEST(ShippedWorlds, AreTheCorridorOfThePaper) {
  for (const char* name : {"corridor_a", "corridor_b", "corridor_c"}) {
    const World world =
        load_world(STRIATE_SOURCE_DIR "/config/worlds/" + std::string(name) + ".yaml");
    EXPECT_DOUBLE_EQ(world.length_m, 60.0);
    EXPECT_DOUBLE_EQ(world.width_m, 2.4);
    EXPECT_EQ(world.obstacles.size(), 7u);
    EXPECT_EQ(world.pillars.size(), 2u);
    EXPECT_FALSE(world.walks.empty());
    EXPECT_FALSE(world.steps_in_front.empty());
    EXPECT_TRUE(world.sun.has_value());
    EXPECT_TRUE(std::any_of(world.lights.begin(), world.lights.end(),
                            [](const LightRow& row) { return row.level <= 0.15; }));
    EXPECT_TRUE(std::any_of(world.walls.begin(), world.walls.end(), [](const WallStretch& wall) {
      return wall.material == "blank_plaster";
    }));
  }
}

}  // namespace
}  // namespace striate::simulator
