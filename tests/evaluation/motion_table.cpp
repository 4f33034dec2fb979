// How well things that move by themselves are told from things that do not, in simulated images,
// while the robot stands, drives, turns, and looks around.
//
//     motion_table [--seed N] [WORLD.yaml ...]
//
// Two people are in view: one walks, the other stands. Columns of the image are judged by which
// true thing is nearest in them; odometry has the scale errors of the simulated base.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "striate/perception/perception.hpp"
#include "striate/platform/simulator/render/renderer.hpp"
#include "striate/platform/simulator/world_reader.hpp"
#include "tests/evaluation/judged_poses.hpp"
#include "tests/evaluation/true_columns.hpp"

namespace {

using namespace striate;
using evaluation::true_columns;
using evaluation::unit_noise;

constexpr double kStep_s = 0.1;
constexpr int kImages = 25;        // of a sequence
constexpr int kFirstJudged = 6;    // exposure settles, earlier images gather
constexpr double kJudged_m = 5.0;  // farther things are not judged
constexpr double kWalks_m_s = 0.9;
constexpr double kOdometryError = 0.0075;  // deviation of the scales of ways and turns

enum class Drive { stands, drives, turns, looks };
enum class Walk { across, towards, away };
constexpr const char* kDrives[] = {"stands", "drives", "drives and turns", "drives, pans head"};
constexpr const char* kWalks[] = {"across", "towards", "away"};

struct Counts {
  long moving = 0, moving_found = 0;    // columns
  long still = 0, still_called = 0;     // columns
  long walkers = 0, walkers_found = 0;  // images that show the walker
  long pictures = 0, false_things = 0;
  std::vector<double> velocity_error_m_s;

  void add(const Counts& o) {
    moving += o.moving, moving_found += o.moving_found;
    still += o.still, still_called += o.still_called;
    walkers += o.walkers, walkers_found += o.walkers_found;
    pictures += o.pictures, false_things += o.false_things;
    velocity_error_m_s.insert(velocity_error_m_s.end(), o.velocity_error_m_s.begin(),
                              o.velocity_error_m_s.end());
  }
};

/// Where everything is in one image. The walker comes first among the people.
struct Moment {
  simulator::SceneState scene;
  Pose2 odometry;
  Point2 walker_m_s;  ///< in the robot frame
};

/// One run: true place and way, drawn by seed.
class Sequence {
 public:
  Sequence(const simulator::FloorPlan& plan, Drive drive, Walk walk, std::uint64_t seed)
      : plan_(plan), drive_(drive), walk_(walk), draw_(seed * 1000) {
    start_m_ = 2.0 + 8.0 * next();
    left_m_ = 0.5 * (next() - 0.5);
    side_ = next() < 0.5 ? -1.0 : 1.0;
    way_scale_ = 1.0 + kOdometryError * 2.0 * (next() - 0.5) * 1.73;
    turn_scale_ = 1.0 + kOdometryError * 2.0 * (next() - 0.5) * 1.73;
    look_ = static_cast<int>(4.0 * next());
    along_m_ = start_m_;
  }

  /// The next image's moment.
  Moment step(std::uint64_t frame) {
    const double t_s = kStep_s * static_cast<double>(count_);
    const double speed = drive_ == Drive::stands ? 0.0 : 0.5;
    const double turn = drive_ == Drive::turns ? 0.5 * std::sin(2.5 * t_s) : 0.0;
    if (count_++ > 0) {
      heading_rad_ += turn * kStep_s;
      along_m_ += speed * kStep_s * std::cos(heading_rad_);
      left_m_ += speed * kStep_s * std::sin(heading_rad_);
      const double told = odometry_.heading_rad + turn_scale_ * turn * kStep_s;
      odometry_ = {odometry_.x_m + way_scale_ * speed * kStep_s * std::cos(told),
                   odometry_.y_m + way_scale_ * speed * kStep_s * std::sin(told), told};
    }
    Moment moment;
    moment.scene.frame = frame;
    moment.scene.time_s = t_s;
    moment.scene.robot = plan_.at(along_m_, left_m_);
    moment.scene.robot.heading_rad += heading_rad_;
    moment.scene.forward_m_s = speed;
    moment.scene.turn_rad_s = turn;
    moment.scene.head.tilt_rad = -0.1;
    if (drive_ == Drive::looks) moment.scene.head.pan_rad = 0.25 * std::sin(2.0 * t_s);
    moment.odometry = odometry_;
    place_people(t_s, moment);
    return moment;
  }

 private:
  double next() { return unit_noise(draw_++); }

  void place_people(double t_s, Moment& moment) {
    const double walked = kWalks_m_s * t_s;
    double along = start_m_ + 3.4, left = side_ * (walked - 1.0), vx = 0.0, vy = 0.0;
    switch (walk_) {
      case Walk::across:
        vy = side_ * kWalks_m_s;
        break;
      case Walk::towards:
        along = start_m_ + 5.5 - walked, left = 0.3 * side_, vx = -kWalks_m_s;
        break;
      case Walk::away:
        along = start_m_ + 2.2 + walked, left = 0.3 * side_, vx = kWalks_m_s;
        break;
    }
    simulator::PersonState walker;
    walker.look = look_;
    walker.pose = plan_.at(along, left);
    walker.pose.heading_rad += std::atan2(vy, vx);
    walker.stride_rad = 6.3 * walked / 1.3;
    walker.speed_m_s = kWalks_m_s;
    simulator::PersonState still;
    still.look = look_ + 1;
    still.pose = plan_.at(start_m_ + 3.9, -0.8 * side_);
    moment.scene.people = {walker, still};
    const double c = std::cos(heading_rad_), s = std::sin(heading_rad_);
    moment.walker_m_s = {c * vx + s * vy, c * vy - s * vx};
  }

  const simulator::FloorPlan& plan_;
  Drive drive_;
  Walk walk_;
  std::uint64_t draw_;
  int count_ = 0;
  double start_m_, along_m_, left_m_, side_, way_scale_, turn_scale_, heading_rad_ = 0.0;
  int look_ = 0;
  Pose2 odometry_;
};

enum class Truth { none, still, moving };

/// Which true thing is nearest in each column: with the walker there, and without.
std::vector<Truth> truth_of(const std::vector<double>& with, const std::vector<double>& without) {
  std::vector<Truth> truth(with.size(), Truth::none);
  for (std::size_t u = 0; u < with.size(); ++u) {
    if (with[u] > kJudged_m) continue;
    truth[u] = with[u] < without[u] - 0.1 ? Truth::moving : Truth::still;
  }
  return truth;
}

void judge(const perception::Percept& percept, const std::vector<Truth>& truth, Point2 walker_m_s,
           Counts& c) {
  const int width = static_cast<int>(truth.size());
  long shown = 0;
  for (int u = 0; u < width; ++u) {
    const bool called = percept.columns[u].moving >= 0.5;
    shown += truth[u] == Truth::moving;
    // At an edge of the walker either may be right.
    const bool edge =
        u < 3 || u >= width - 3 || truth[u - 3] != truth[u] || truth[u + 3] != truth[u];
    if (edge || truth[u] == Truth::none) continue;
    (truth[u] == Truth::moving ? c.moving : c.still) += 1;
    (truth[u] == Truth::moving ? c.moving_found : c.still_called) += called;
  }
  ++c.pictures;
  bool found = false;
  for (const perception::MovingThing& thing : percept.moving) {
    long on_walker = 0;
    for (int u = thing.from_u_px; u <= thing.to_u_px; ++u) {
      // Matching widens a thing by some pixels: they are the walker's.
      bool near = false;
      for (int n = std::max(0, u - 3); n <= std::min(width - 1, u + 3); ++n) {
        near = near || truth[n] == Truth::moving;
      }
      on_walker += near;
    }
    const bool right = 2 * on_walker >= thing.to_u_px - thing.from_u_px + 1;
    c.false_things += !right;
    found = found || right;
    if (right && thing.velocity_known) {
      c.velocity_error_m_s.push_back(
          std::hypot(thing.forward_m_s - walker_m_s.x_m, thing.left_m_s - walker_m_s.y_m));
    }
  }
  if (shown < 8) return;
  ++c.walkers;
  c.walkers_found += found;
}

struct World {
  simulator::World world;
  simulator::FloorPlan plan;
  simulator::Renderer renderer;
};

Counts run(World& world, Drive drive, Walk walk, std::uint64_t seed) {
  perception::PerceptionSettings settings;
  settings.motion.on = true;
  settings.keypoints_every = 0;
  const RobotDescription robot;
  perception::Perception perception(settings, robot);
  Sequence sequence(world.plan, drive, walk, seed);
  Counts counts;
  for (int k = 0; k < kImages; ++k) {
    const Moment moment = sequence.step(static_cast<std::uint64_t>(k));
    StereoFrame frame = world.renderer.image(moment.scene);
    frame.head = moment.scene.head;
    frame.stamp = TimePoint{} + from_seconds(moment.scene.time_s);
    const perception::Percept percept = perception.see(frame, moment.odometry);
    if (k < kFirstJudged) continue;
    const auto columns_of = [&](const simulator::SceneState& scene) {
      return true_columns(world.renderer.true_depth(scene, 160), percept.disparity, frame.head,
                          robot);
    };
    simulator::SceneState without = moment.scene;
    without.people.erase(without.people.begin());
    const std::vector<double> with = columns_of(moment.scene);
    if (*std::min_element(with.begin(), with.end()) < 0.5) break;  // somebody is run into
    judge(percept, truth_of(with, columns_of(without)), moment.walker_m_s, counts);
  }
  return counts;
}

double median(std::vector<double> values) {
  if (values.empty()) return std::nan("");
  std::nth_element(values.begin(), values.begin() + static_cast<long>(values.size() / 2),
                   values.end());
  return values[values.size() / 2];
}

void print_row(const std::string& name, const Counts& c) {
  const auto share = [](long part, long whole) { return whole > 0 ? 100.0 * part / whole : 0.0; };
  fmt::print("{:<30}{:>9}{:>9.1f}{:>9}{:>9.2f}{:>11.1f}{:>11.2f}{:>11.2f}\n", name, c.moving,
             share(c.moving_found, c.moving), c.still, share(c.still_called, c.still),
             share(c.walkers_found, c.walkers), share(c.false_things, c.pictures),
             median(c.velocity_error_m_s));
}

}  // namespace

int main(int argc, char** argv) {
  std::uint64_t seed = 1;
  std::vector<std::string> files;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument == "--seed" && i + 1 < argc) {
      seed = std::stoull(argv[++i]);
    } else {
      files.push_back(argument);
    }
  }
  if (files.empty()) {
    for (const char* name : {"corridor_a", "corridor_b", "corridor_c"}) {
      files.push_back(fmt::format("{}/config/worlds/{}.yaml", STRIATE_SOURCE_DIR, name));
    }
  }
  fmt::print("{:<30}{:>9}{:>9}{:>9}{:>9}{:>11}{:>11}{:>11}\n", "robot: walker", "moving", "found%",
             "still", "called%", "walkers%", "false/100", "v err m/s");
  std::vector<Counts> counts(12);
  for (const std::string& file : files) {
    const simulator::World world = simulator::load_world(file);
    const simulator::FloorPlan plan = simulator::build_floor_plan(world);
    World all{world, plan, simulator::Renderer(world, plan, {}, seed)};
    for (int d = 0; d < 4; ++d) {
      for (int w = 0; w < 3; ++w) {
        counts[3 * d + w].add(run(all, static_cast<Drive>(d), static_cast<Walk>(w),
                                  100 * seed + static_cast<std::uint64_t>(3 * d + w)));
      }
    }
  }
  Counts sum;
  for (int k = 0; k < 12; ++k) {
    print_row(fmt::format("{}: {}", kDrives[k / 3], kWalks[k % 3]), counts[k]);
    sum.add(counts[k]);
  }
  print_row("all", sum);
  return 0;
}
