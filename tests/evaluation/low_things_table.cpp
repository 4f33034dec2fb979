// How low a thing may be that is still seen, and how often something low is seen that is not there.
//
//     low_things_table [--off] [--boxes] [--phantoms] [--margin=PX] [--standing=PX] [--lowest=M]
//                      [--smallest=M] [--area=PX]
//
// Boxes of several heights stand ahead on the floor of a simulated corridor, in several colours and
// lights; a box is seen when half of the columns that it fills say so, within 0.15 m. Phantoms are
// columns of the shipped corridors that claim something nearer than 3 m where true depth has none.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>
#include <vector>

#include "striate/perception/perception.hpp"
#include "striate/platform/simulator/render/renderer.hpp"
#include "striate/platform/simulator/world_reader.hpp"
#include "tests/evaluation/judged_poses.hpp"
#include "tests/evaluation/true_columns.hpp"

namespace {

using namespace striate;

constexpr double kBoxFront_m = 7.85;  // x; 0.3 m long, middle at 8 m
constexpr double kGlance_rad = -0.42;
constexpr int kWarmUpImages = 3;  // for the exposure to settle

struct Scene {
  const char* name;
  const char* image;
  const char* floor;
  double light;
};
constexpr Scene kScenes[] = {{"cardboard", "", "linoleum", 0.8},
                             {"cardboard dim", "", "linoleum", 0.25},
                             {"cardboard dark", "", "linoleum", 0.08},
                             {"white", "paint_white", "linoleum", 0.8},
                             {"grey on carpet", "paint_grey", "carpet", 0.6},
                             {"wood on tiles", "wood", "tiles", 0.8}};

simulator::World world_with(const Scene& scene, double height_m) {
  const std::string image = *scene.image != '\0' ? fmt::format(", image: {}", scene.image) : "";
  const std::string box = fmt::format(
      "obstacles: [{{kind: cardboard_box, at: [8 m, 0 m], size: [0.3 m, 0.35 m, {} m]{}}}]\n",
      height_m, image);
  const std::string text = fmt::format(
      "striate_world: 1\nname: low\ncorridor: {{length: 14 m, width: 2.2 m}}\n"
      "floor_material: {}\nlights: [{{from: 0 m, to: 14 m, every: 4 m, level: {}}}]\n{}"
      "start: {{at: [1 m, 0 m]}}\n",
      scene.floor, scene.light, height_m > 0.0 ? box : "");
  config::Diagnostics diagnostics("low.yaml");
  simulator::World world = simulator::parse_world(text, diagnostics);
  if (!diagnostics.none()) throw std::runtime_error(diagnostics.text());
  return world;
}

struct Tally {
  int seen = 0;
  int all = 0;
};

bool sees_box(const perception::Percept& percept, double front_m) {
  int right = 0;
  int columns = 0;
  for (const perception::Column& column : percept.columns) {
    if (std::abs(std::tan(column.bearing_rad)) * front_m > 0.14) continue;
    ++columns;
    right += std::abs(column.obstacle_m * std::cos(column.bearing_rad) - front_m) < 0.15;
  }
  return columns > 0 && 2 * right >= columns;
}

struct Eyes {
  simulator::Renderer& renderer;
  const simulator::FloorPlan& plan;
  perception::Perception& perception;
  std::uint64_t frame = 0;

  perception::Percept look(const evaluation::Pose& pose) {
    StereoFrame image;
    for (int i = 0; i < kWarmUpImages; ++i) {
      image = renderer.image(evaluation::scene_at(plan, pose, frame++));
    }
    image.head = pose.head;
    return perception.see(image);
  }
};

void box_table(const perception::PerceptionSettings& settings) {
  const std::vector<double> heights_m{0.04, 0.05, 0.06, 0.08, 0.10, 0.12, 0.15};
  struct View {
    double distance_m;
    double tilt_rad;
  };
  const std::vector<View> views{{1.55, kGlance_rad},
                                {1.8, kGlance_rad},
                                {2.2, RobotDescription{}.resting_tilt_rad},
                                {2.6, RobotDescription{}.resting_tilt_rad},
                                {3.0, RobotDescription{}.resting_tilt_rad}};
  fmt::print("{:<16}{:>7}", "seen of 6", "height");
  for (const View& view : views) fmt::print("{:>9.2f} m", view.distance_m);
  fmt::print("\n");
  for (const Scene& scene : kScenes) {
    for (const double height_m : heights_m) {
      const simulator::World world = world_with(scene, height_m);
      const simulator::FloorPlan plan = simulator::build_floor_plan(world);
      simulator::Renderer renderer(world, plan, {}, 1);
      perception::Perception perception(settings, {});
      Eyes eyes{renderer, plan, perception};
      fmt::print("{:<16}{:>7.2f}", scene.name, height_m);
      for (const View& view : views) {
        int seen = 0;
        for (int k = 0; k < 6; ++k) {
          evaluation::Pose pose;
          pose.along_m = kBoxFront_m - view.distance_m + 0.02 * k;
          pose.left_m = 0.0;
          pose.head.tilt_rad = view.tilt_rad;
          seen += sees_box(eyes.look(pose), view.distance_m - 0.02 * k);
        }
        fmt::print("{:>11}", seen);
      }
      fmt::print("\n");
    }
  }
}

void phantom_table(const perception::PerceptionSettings& settings) {
  constexpr double kNear_m = 3.0;
  fmt::print("\n{:<16}{:>8}{:>12}{:>12}\n", "phantoms", "images", "columns %", "images %");
  for (const char* name : {"corridor_a", "corridor_b", "corridor_c", "hard_dark_people",
                           "hard_blank_wall", "objects_find"}) {
    const std::string file = fmt::format("{}/config/worlds/{}.yaml", STRIATE_SOURCE_DIR, name);
    const simulator::World world = simulator::load_world(file);
    const simulator::FloorPlan plan = simulator::build_floor_plan(world);
    simulator::Renderer renderer(world, plan, {}, 1);
    perception::Perception perception(settings, {});
    Eyes eyes{renderer, plan, perception};
    long images = 0, columns = 0, phantoms = 0, with = 0;
    int k = 0;
    for (evaluation::Pose pose : evaluation::poses_of(world, 1)) {
      pose.person = false;
      pose.head.tilt_rad = k++ % 2 == 0 ? kGlance_rad : RobotDescription{}.resting_tilt_rad;
      const perception::Percept percept = eyes.look(pose);
      simulator::SceneState state = evaluation::scene_at(plan, pose, eyes.frame - 1);
      const cv::Mat1f depth = renderer.true_depth(state, percept.disparity.disparity_px.cols);
      const std::vector<double> truth =
          evaluation::true_columns(depth, percept.disparity, pose.head, {}, 0.03);
      if (*std::min_element(truth.begin(), truth.end()) < 0.4) continue;
      int here = 0;
      const int width = static_cast<int>(truth.size());
      for (int u = 0; u < width; ++u) {
        double nearest = perception::kNothing_m;
        for (int n = std::max(0, u - 3); n <= std::min(width - 1, u + 3); ++n) {
          nearest = std::min(nearest, truth[n]);
        }
        const double claim_m = percept.columns[u].obstacle_m;
        here += claim_m < kNear_m && claim_m < nearest - 0.25;
      }
      ++images;
      columns += width;
      phantoms += here;
      with += here > 3;
    }
    fmt::print("{:<16}{:>8}{:>12.2f}{:>12.1f}\n", name, images, 100.0 * phantoms / columns,
               100.0 * with / images);
  }
}

}  // namespace

int main(int argc, char** argv) {
  perception::PerceptionSettings settings;
  bool boxes = true;
  bool phantoms = true;
  for (int i = 1; i < argc; ++i) {
    const std::string given = argv[i];
    const auto value = [&](const char* key) {
      const std::size_t length = std::strlen(key);
      return given.compare(0, length, key) == 0 ? given.c_str() + length : nullptr;
    };
    if (given == "--off") settings.low_things.on = false;
    if (given == "--boxes") phantoms = false;
    if (given == "--phantoms") boxes = false;
    if (const char* v = value("--margin=")) settings.low_things.floor_margin_px = std::atof(v);
    if (const char* v = value("--standing=")) settings.low_things.standing_px = std::atof(v);
    if (const char* v = value("--lowest=")) settings.low_things.lowest_m = std::atof(v);
    if (const char* v = value("--smallest=")) settings.low_things.smallest_m = std::atof(v);
    if (const char* v = value("--area=")) settings.low_things.smallest_px = std::atof(v);
  }
  if (boxes) box_table(settings);
  if (phantoms) phantom_table(settings);
  return 0;
}
