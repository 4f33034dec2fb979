#include "striate/platform/simulator/render/stage.hpp"

#include <set>

#include "striate/platform/simulator/static_shapes.hpp"

namespace striate::simulator::render {
namespace {

/// Outdoors is some fifty times brighter than an office; tinted panes and a camera that would be
/// blinded either way allow less.
constexpr float kSunIrradiance = 9.0F;
/// Irradiance through a window, where a lamp's floor has about 1
constexpr float kOvercastSky = 1.0F;
/// Irradiance through a window, where a lamp's floor has about 1 (ours)
constexpr float kClearSky = 3.5F;
constexpr float kPiece_m = 4.0F;  ///< floor and ceiling are laid in pieces of at most this

/// Between two neighbouring corners' x the outline's inside, without its holes, is a row of
/// trapezoids.
struct Slab {
  float x0, x1;
  float low0, low1;  ///< y at x0 and at x1
  float high0, high1;
};

std::vector<Slab> slabs_of(const std::vector<std::vector<Point2>>& outlines) {
  std::set<double> xs;
  for (const std::vector<Point2>& outline : outlines) {
    for (const Point2& p : outline) {
      if (xs.lower_bound(p.x_m - 1e-3) == xs.upper_bound(p.x_m + 1e-3)) xs.insert(p.x_m);
    }
  }
  std::vector<Slab> slabs;
  for (auto a = xs.begin(), b = std::next(a); b != xs.end(); ++a, ++b) {
    std::vector<std::pair<double, double>> crossings;  // y at *a, y at *b
    for (const std::vector<Point2>& outline : outlines) {
      for (std::size_t i = 0; i < outline.size(); ++i) {
        const Point2 p = outline[i];
        const Point2 q = outline[(i + 1) % outline.size()];
        const double middle = (*a + *b) / 2.0;
        if ((p.x_m < middle) == (q.x_m < middle)) continue;
        const double slope = (q.y_m - p.y_m) / (q.x_m - p.x_m);
        crossings.emplace_back(p.y_m + slope * (*a - p.x_m), p.y_m + slope * (*b - p.x_m));
      }
    }
    std::sort(crossings.begin(), crossings.end(),
              [](const auto& p, const auto& q) { return p.first + p.second < q.first + q.second; });
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
      const auto f = [](double v) { return static_cast<float>(v); };
      slabs.push_back({f(*a), f(*b), f(crossings[i].first), f(crossings[i].second),
                       f(crossings[i + 1].first), f(crossings[i + 1].second)});
    }
  }
  return slabs;
}

void lay(PatchList& patches, const Slab& slab, float z_m, int material, bool faces_up) {
  const float tall = std::max(slab.high0 - slab.low0, slab.high1 - slab.low1);
  const int nx = std::max(1, static_cast<int>(std::ceil((slab.x1 - slab.x0) / kPiece_m)));
  const int ny = std::max(1, static_cast<int>(std::ceil(tall / kPiece_m)));
  const auto corner = [&](int i, int j) {
    const float u = static_cast<float>(i) / static_cast<float>(nx);
    const float v = static_cast<float>(j) / static_cast<float>(ny);
    const float low = slab.low0 + (slab.low1 - slab.low0) * u;
    const float high = slab.high0 + (slab.high1 - slab.high0) * u;
    return Vec3{slab.x0 + (slab.x1 - slab.x0) * u, low + (high - low) * v, z_m};
  };
  for (int i = 0; i < nx; ++i) {
    for (int j = 0; j < ny; ++j) {
      std::array<Vec3, 4> q{corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)};
      if (!faces_up) std::swap(q[1], q[3]);
      patches.quad(q, material, {q[0].x, q[1].x, q[2].x, q[3].x},
                   {-q[0].y, -q[1].y, -q[2].y, -q[3].y});
    }
  }
}

}  // namespace

void add_floor_and_ceiling(PatchList& patches, const World& world, const FloorPlan& plan) {
  const int floor = patches.materials().find(world.floor_material, "floor");
  const int ceiling = patches.materials().find("ceiling", "ceiling");
  std::vector<std::vector<Point2>> outlines{plan.outline};
  const std::vector<Slab> slabs = slabs_of(outlines);
  for (const StaticShape& drop : drops(world, plan)) outlines.push_back(drop.shape.corners);
  patches.next_group();
  patches.set_spacing(0.1F);
  for (const Slab& slab : slabs_of(outlines)) lay(patches, slab, 0.0F, floor, true);
  patches.next_group();
  patches.set_spacing(0.3F);
  for (const Slab& slab : slabs) {
    lay(patches, slab, static_cast<float>(plan.height_m), ceiling, false);
  }
}

namespace {

/// Who walls up a place leaves no lamp in it, which would shine out under the wall.
bool within_an_inner_wall(const Pose2& place, const std::vector<StaticShape>& walls) {
  return std::any_of(walls.begin(), walls.end(), [&](const StaticShape& wall) {
    return distance_m(disc({place.x_m, place.y_m}, 0.0), wall.shape) <= 0.0;
  });
}

}  // namespace

void add_lamps(PatchList& patches, std::vector<Lamp>& lamps, const World& world,
               const FloorPlan& plan) {
  constexpr float kHalfLength_m = 0.6F;  // of a fluorescent panel, 1.2 m as 36 W tubes are
  constexpr float kHalfWidth_m = 0.15F;  // of a fluorescent panel of 0.3 m
  constexpr float kExitance = 36.0F;     // measured: about 1.0 on the floor with one panel each 4 m
  const int housing = patches.materials().find("paint_white", "lamp");
  World walled = with_obstacles(
      world, [](const WorldObstacle& thing) { return thing.kind == ObstacleKind::wall; });
  walled.pillars.clear();
  const std::vector<StaticShape> walls = standing_shapes(walled, plan);
  patches.set_spacing(0.4F);
  for (const LightRow& row : world.lights) {
    const double every = std::max(row.every_m, 0.5);
    for (double along = row.from_m + every / 2.0; along < row.to_m; along += every) {
      if (within_an_inner_wall(plan.at(along, row.left_m), walls)) continue;
      const Stand stand{plan.at(along, row.left_m), static_cast<float>(plan.height_m) - 0.06F};
      patches.block(stand, {{-0.63F, -0.18F, 0.0F}, {0.63F, 0.18F, 0.06F}}, housing, housing, true);
      patches.next_group();
      const float exitance = kExitance * static_cast<float>(row.level);
      const Vec3 centre = stand.point(0.0F, 0.0F, -0.004F);
      const Vec3 a = stand.point(kHalfLength_m, 0.0F, -0.004F) - centre;
      const Vec3 b = stand.point(0.0F, kHalfWidth_m, -0.004F) - centre;
      const int panel = exitance > 0.0F ? patches.materials().lamp(exitance) : housing;
      patches.rectangle(centre - a - b, b * 2.0F, a * 2.0F, panel);
      if (exitance > 0.0F) lamps.push_back({centre, a, b, exitance, {0.0F, 0.0F, -1.0F}});
    }
  }
}

Stage build_stage(const World& world, const FloorPlan& plan) {
  Stage stage{Materials(world.file), {}, 0, {}, {}, std::nullopt, Outdoors(), 0.0F};
  PatchList patches(stage.materials);
  add_floor_and_ceiling(patches, world, plan);
  add_walls(patches, stage.windows, world, plan);
  add_lamps(patches, stage.lamps, world, plan);
  for (const Pillar& pillar : world.pillars) add_pillar(patches, pillar, world, plan);
  for (const WorldObstacle& obstacle : world.obstacles) add_obstacle(patches, obstacle, plan);
  for (const FloorPatch& patch : world.floor_patches) add_floor_patch(patches, patch, world, plan);
  for (const WorldObject& object : world.objects) add_object(patches, object, plan);
  stage.light_texels = patches.light_texels();
  stage.patches = patches.take();
  stage.sky = kOvercastSky;
  if (world.sun && world.sun->level > 0.0 && world.sun->elevation_rad > 0.0) {
    const double c = std::cos(world.sun->elevation_rad);
    const auto f = [](double v) { return static_cast<float>(v); };
    stage.sun =
        SunLight{{f(c * std::cos(world.sun->azimuth_rad)), f(c * std::sin(world.sun->azimuth_rad)),
                  f(std::sin(world.sun->elevation_rad))},
                 kSunIrradiance * f(world.sun->level)};
    stage.sky += (kClearSky - kOvercastSky) * f(std::min(world.sun->level, 1.0));
  }
  return stage;
}

}  // namespace striate::simulator::render
