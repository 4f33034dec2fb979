// How right the columns and the corridor's heading are on simulated images, against true depth.
//
//     obstacle_table [--images DIR] [--mode paper|robust] [--seed N] [WORLD.yaml ...]
//
// Phantoms (something claimed that is not there) make the robot stop or swerve, missed near things
// make it collide: both are counted per column, together with what is right and what is unknown.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <opencv2/imgcodecs.hpp>
#include <string>
#include <vector>

#include "striate/agent/pictures/overview.hpp"
#include "striate/perception/perception.hpp"
#include "striate/platform/simulator/render/renderer.hpp"
#include "striate/platform/simulator/world_reader.hpp"
#include "tests/evaluation/judged_poses.hpp"
#include "tests/evaluation/true_columns.hpp"

namespace {

using namespace striate;
using evaluation::Pose;
using evaluation::poses_of;
using evaluation::scene_at;
using evaluation::true_columns;

constexpr double kJudged_m = 6.0;   // farther things are not judged
constexpr double kPhantom_m = 3.0;  // phantoms nearer than this count
constexpr double kMissed_m = 2.5;   // things nearer than this must not be called free
constexpr int kWarmUp = 3;          // images for the exposure to settle

struct Counts {
  long columns = 0;  ///< with something true within kJudged_m
  long right = 0;
  long unknown = 0;  ///< nothing claimed
  long phantom = 0;
  long phantom_sure = 0;  ///< with confidence above one half
  long all = 0;           ///< columns in all, for the phantoms' share
  long near = 0;          ///< something true within kMissed_m
  long near_right = 0;
  long near_free = 0;  ///< and called free
  double free_m = 0.0;
  long frames = 0;
  long corridor_valid = 0;
  std::vector<double> heading_error_deg;
  std::vector<double> sure_error_deg;
  std::vector<double> wall_error_m;
  double see_ms = 0.0;

  void add(const Counts& o) {
    columns += o.columns, right += o.right, unknown += o.unknown, phantom += o.phantom;
    phantom_sure += o.phantom_sure, all += o.all, near += o.near, near_right += o.near_right;
    near_free += o.near_free, free_m += o.free_m, frames += o.frames;
    corridor_valid += o.corridor_valid, see_ms += o.see_ms;
    const auto append = [](auto& to, const auto& from) {
      to.insert(to.end(), from.begin(), from.end());
    };
    append(heading_error_deg, o.heading_error_deg);
    append(sure_error_deg, o.sure_error_deg);
    append(wall_error_m, o.wall_error_m);
  }
};

bool close(double claim_m, double truth_m) {
  return std::abs(claim_m - truth_m) <= std::max(0.15, 0.1 * truth_m);
}

void judge_columns(const perception::Percept& percept, const std::vector<double>& truth,
                   Counts& counts) {
  const int width = static_cast<int>(truth.size());
  for (int u = 0; u < width; ++u) {
    const perception::Column& c = percept.columns[u];
    double nearest =
        perception::kNothing_m;  // of this column and its neighbours: edges may fall either way
    double farthest = 0.0;
    bool right = false;
    for (int n = std::max(0, u - 2); n <= std::min(width - 1, u + 2); ++n) {
      nearest = std::min(nearest, truth[n]);
      farthest = std::max(farthest, truth[n]);
      right = right || close(c.obstacle_m, truth[n]);
    }
    ++counts.all;
    counts.free_m += std::max(0.0, c.free_to_m - c.free_from_m);
    const bool phantom = !right && c.obstacle_m < kPhantom_m && c.obstacle_m < nearest - 0.3;
    counts.phantom += phantom;
    counts.phantom_sure += phantom && c.obstacle_confidence > 0.5;
    if (truth[u] > kJudged_m) continue;
    ++counts.columns;
    counts.right += right;
    counts.unknown += !std::isfinite(c.obstacle_m);
    if (farthest > kMissed_m) continue;
    ++counts.near;
    counts.near_right += right;
    counts.near_free += c.free_to_m > c.free_from_m && c.free_to_m > farthest + 0.15;
  }
}

double width_at(const simulator::World& world, double along_m) {
  for (const simulator::Widening& w : world.widenings) {
    if (along_m > w.from_m && along_m < w.to_m) return w.width_m;
  }
  return world.width_m;
}

void judge_corridor(const perception::Percept& percept, const Pose& pose,
                    const simulator::World& world, Counts& counts) {
  if (!percept.corridor.valid) return;
  ++counts.corridor_valid;
  // An axis has no direction: a heading of 180 degrees more is the same corridor.
  const double error =
      std::remainder(degrees(percept.corridor.heading_rad + pose.heading_rad), 180.0);
  counts.heading_error_deg.push_back(std::abs(error));
  if (percept.corridor.confidence > 0.5) counts.sure_error_deg.push_back(std::abs(error));
  const double half = 0.5 * width_at(world, pose.along_m + 1.5);
  if (width_at(world, pose.along_m + 5.0) != 2.0 * half) return;
  if (std::isfinite(percept.corridor.left_m)) {
    counts.wall_error_m.push_back(std::abs(percept.corridor.left_m - (half - pose.left_m)));
  }
  if (std::isfinite(percept.corridor.right_m)) {
    counts.wall_error_m.push_back(std::abs(percept.corridor.right_m - (half + pose.left_m)));
  }
}

double quantile(std::vector<double> values, double q) {
  if (values.empty()) return 0.0;
  std::sort(values.begin(), values.end());
  return values[std::min(values.size() - 1, static_cast<std::size_t>(q * values.size()))];
}

void print_head() {
  fmt::print(
      "{:<16}{:>7}{:>8}{:>8}{:>9}{:>9}{:>9}{:>10}{:>8} |{:>7}{:>7}{:>7}{:>7}{:>8}{:>7}{:>7} "
      "|{:>6}\n",
      "world", "frames", "right%", "unkn%", "phant%", "sure%", "near-ok%", "near-free%", "free m",
      "valid%", "med", "p95", "max.5", "n.5%", "wall m", "p90", "ms");
}

void print_row(const std::string& name, const Counts& c) {
  const auto share = [](long part, long whole) { return whole > 0 ? 100.0 * part / whole : 0.0; };
  fmt::print(
      "{:<16}{:>7}{:>8.1f}{:>8.1f}{:>9.2f}{:>9.2f}{:>9.1f}{:>10.2f}{:>8.2f} "
      "|{:>7.0f}{:>7.2f}{:>7.1f}{:>7.1f}"
      "{:>8.0f}{:>7.2f}{:>7.2f} |{:>6.2f}\n",
      name, c.frames, share(c.right, c.columns), share(c.unknown, c.columns),
      share(c.phantom, c.all), share(c.phantom_sure, c.all), share(c.near_right, c.near),
      share(c.near_free, c.near), c.free_m / std::max(1L, c.all), share(c.corridor_valid, c.frames),
      quantile(c.heading_error_deg, 0.5), quantile(c.heading_error_deg, 0.95),
      quantile(c.sure_error_deg, 1.0), share(static_cast<long>(c.sure_error_deg.size()), c.frames),
      quantile(c.wall_error_m, 0.5), quantile(c.wall_error_m, 0.9),
      c.see_ms / std::max(1L, c.frames));
}

struct Run {
  perception::PerceptionSettings settings;
  std::string pictures;
  RobotDescription robot;
  std::uint64_t seed = 0;
};

Counts evaluate(const std::string& file, const Run& run) {
  const simulator::World world = simulator::load_world(file);
  const simulator::FloorPlan plan = simulator::build_floor_plan(world);
  simulator::Renderer renderer(world, plan, {}, run.seed + 1);
  perception::Perception perception(run.settings, run.robot);
  Counts counts;
  std::uint64_t frame_number = 0;
  for (const Pose& pose : poses_of(world, run.seed)) {
    simulator::SceneState state = scene_at(plan, pose, frame_number);
    StereoFrame frame;
    for (int i = 0; i < kWarmUp; ++i) {
      state.frame = frame_number++;
      frame = renderer.image(state);
    }
    frame.head = pose.head;
    const auto before = std::chrono::steady_clock::now();
    const perception::Percept percept = perception.see(frame);
    const std::chrono::duration<double, std::milli> took =
        std::chrono::steady_clock::now() - before;
    const cv::Mat1f depth = renderer.true_depth(state, percept.disparity.disparity_px.cols);
    const std::vector<double> truth = true_columns(depth, percept.disparity, pose.head, run.robot);
    if (*std::min_element(truth.begin(), truth.end()) < 0.4) continue;  // inside a thing
    Counts one;
    one.frames = 1;
    one.see_ms = took.count();
    judge_columns(percept, truth, one);
    judge_corridor(percept, pose, world, one);
    counts.add(one);
    if (!run.pictures.empty()) {
      const std::string name = fmt::format(
          "{}/{}_{:04.1f}_ph{:03d}_free{:03d}_head{:04.1f}.png", run.pictures,
          std::filesystem::path(file).stem().string(), pose.along_m, one.phantom, one.near_free,
          one.heading_error_deg.empty() ? 99.0 : one.heading_error_deg[0]);
      cv::imwrite(name, agent::pictures::draw_overview(frame, percept, run.robot));
    }
  }
  return counts;
}

}  // namespace

int main(int argc, char** argv) {
  Run run;
  std::vector<std::string> worlds;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument == "--pictures" && i + 1 < argc) {
      run.pictures = argv[++i];
      std::filesystem::create_directories(run.pictures);
    } else if (argument == "--mode" && i + 1 < argc) {
      run.settings.stereo.mode = std::string(argv[++i]) == "paper" ? perception::StereoMode::paper
                                                                   : perception::StereoMode::robust;
    } else if (argument == "--seed" && i + 1 < argc) {
      run.seed = std::stoull(argv[++i]);
    } else {
      worlds.push_back(argument);
    }
  }
  if (worlds.empty()) {
    for (const char* name : {"corridor_a", "corridor_b", "corridor_c"}) {
      worlds.push_back(fmt::format("{}/config/worlds/{}.yaml", STRIATE_SOURCE_DIR, name));
    }
  }
  print_head();
  Counts all;
  for (const std::string& file : worlds) {
    const Counts counts = evaluate(file, run);
    print_row(std::filesystem::path(file).stem().string(), counts);
    all.add(counts);
  }
  if (worlds.size() > 1) print_row("all", all);
  return 0;
}
