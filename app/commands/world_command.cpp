#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "striate/app/command_line/found_file.hpp"
#include "striate/app/command_line/whole_number.hpp"
#include "striate/app/commands/commands.hpp"
#include "striate/app/pose_text.hpp"
#include "striate/app/trial/drawn_worlds.hpp"
#include "striate/base/files.hpp"
#include "striate/base/say.hpp"
#include "striate/base/user_error.hpp"
#include "striate/platform/datasets/maps/read_map.hpp"
#include "striate/platform/interface/robot.hpp"
#include "striate/platform/simulator/passage.hpp"
#include "striate/platform/simulator/random_world/random_world.hpp"
#include "striate/platform/simulator/world_description.hpp"
#include "striate/platform/simulator/world_from_map.hpp"
#include "striate/platform/simulator/world_reader.hpp"
#include "striate/platform/simulator/world_writer.hpp"

namespace striate::app {
namespace {

struct WorldOptions {
  std::string world;
  bool random = false;
  std::uint64_t seed = 1;  // any; the first of a set
  std::string kind;
  std::string out;
  int count = 1;
  std::string map;
  std::string at;  // the start, in the map's frame
};

/// A way that is narrower than the robot is a mistake of the world's, one that is narrower than
/// what drawn worlds have is worth a word.
int describe_world(const std::string& file) {
  const simulator::World world = simulator::load_world(file);
  const simulator::FloorPlan plan = simulator::build_floor_plan(world);
  const simulator::Passage passage = simulator::widest_passage(world, plan);
  fmt::print("{}: {}\n{}", file, world.name, simulator::describe_world(world, plan, passage));
  const double robot_m = 2.0 * RobotDescription{}.half_width_m;
  if (passage.width_m <= robot_m) {
    throw UserError(
        fmt::format("{}: error: the robot ({:.2f} m wide) does not get from start to goal\n"
                    "    the way is {:.2f} m wide where it is narrowest",
                    file, robot_m, passage.width_m));
  }
  if (passage.width_m < simulator::kDrivable_m) {
    say(stderr, fmt::format("{}: warning: a way of less than {:.2f} m leaves the robot ({:.2f} m "
                            "wide) little room\n",
                            file, simulator::kDrivable_m, robot_m));
  }
  return 0;
}

/// One to a file or to standard output, many to a folder.
int draw(const WorldOptions& options) {
  const bool folder = options.count > 1;
  if (folder && options.out.empty()) {
    throw UserError(
        "striate world: --count writes many files: say --out FOLDER\n"
        "    e.g. striate world --random --seed 1 --count 200 --out out/worlds");
  }
  if (folder) {
    make_folder(options.out, "--out");
  } else {
    check_writable(options.out);
  }
  for (int i = 0; i < options.count; ++i) {
    const std::uint64_t seed = options.seed + static_cast<std::uint64_t>(i);
    const simulator::RandomWorld drawn =
        simulator::draw_random_world(building_kind_named(options.kind, seed), seed);
    if (options.out.empty()) {
      fmt::print("{}", drawn.yaml);
      continue;
    }
    const std::string file =
        folder ? fmt::format("{}/{}.yaml", options.out, drawn.world.name) : options.out;
    write_file(file, drawn.yaml);
    fmt::print("{}: narrowest passage {:.2f} m, proposal {}\n", file, drawn.passage.width_m,
               drawn.proposals);
  }
  return 0;
}

/// A world of a map that others have made.
int build_from_map(const WorldOptions& options) {
  check_writable(options.out);
  std::optional<Pose2> start;
  if (!options.at.empty()) start = parse_pose(options.at);
  const datasets::OccupancyMap map = datasets::read_map(options.map);
  const auto cells = [&](datasets::MapCell kind) {
    return cv::Mat1b(map.cells == static_cast<int>(kind));
  };
  const simulator::MapWorld made = simulator::world_from_map(
      {cells(datasets::MapCell::stands), cells(datasets::MapCell::free), map.cell_m, map.origin},
      std::filesystem::path(options.map).stem().string(), start);
  simulator::WorldNotes notes;
  notes.head = fmt::format(
      "Made of the map {}. A place x, y of the map is {} here.\n",
      std::filesystem::path(options.map).filename().string(),
      made.turned ? fmt::format("y {:+.3f} m, -x {:+.3f} m", made.moved.x_m, made.moved.y_m)
                  : fmt::format("x {:+.3f} m, y {:+.3f} m", made.moved.x_m, made.moved.y_m));
  const std::string yaml = simulator::world_as_yaml(made.world, notes);
  if (options.out.empty()) {
    fmt::print("{}", yaml);
    return 0;
  }
  write_file(options.out, yaml);
  fmt::print("{}: {:.1f} m x {:.1f} m, {} pieces of wall, start {:.2f} m, {:.2f} m\n", options.out,
             made.world.length_m, made.world.width_m, made.world.obstacles.size(),
             made.world.start.x_m, made.world.start.y_m);
  return 0;
}

}  // namespace

void add_world_command(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<WorldOptions>();
  CLI::App* command = app.add_subcommand(
      "world",
      "Checks and describes a world, or draws one: a building with a way of 0.75 m from start to\n"
      "goal. The same seed and kind give the same file. Exit code 2 if a world has a mistake, or\n"
      "no way through that the robot fits in.\n"
      "Examples: striate world corridor_a\n"
      "          striate world --random --seed 7 --kind hospital --out my_hospital.yaml\n"
      "          striate world --random --seed 1 --count 200 --out out/worlds\n"
      "          striate world --from-map office.yaml --out office_world.yaml");
  CLI::Option* file = command->add_option("world", options->world, "a world file to describe");
  CLI::Option* random =
      command->add_flag("--random", options->random, "draws a building")->excludes(file);
  CLI::Option* map = command
                         ->add_option("--from-map", options->map,
                                      "builds the walls of a map of ROS's map_server or Nav2")
                         ->type_name("FILE.yaml")
                         ->excludes(file)
                         ->excludes(random);
  command
      ->add_option("--at", options->at,
                   "where the robot starts, in the map's frame; without it where there is room")
      ->type_name("PLACE")
      ->needs(map);
  command->add_option("--seed", options->seed, "of the building, or of the first one")
      ->needs(random)
      ->check(whole_number_from(0))
      ->capture_default_str();
  command
      ->add_option("--kind", options->kind,
                   "of building; without it one kind after the other, by seed")
      ->needs(random)
      ->check(CLI::IsMember(simulator::building_kinds()));
  command
      ->add_option("--out", options->out,
                   "the file to write, with --count a folder; without it standard output")
      ->excludes(file);
  command->add_option("--count", options->count, "how many, with seeds that go on from --seed")
      ->needs(random)
      ->check(CLI::Range(1, 100000))
      ->capture_default_str();
  command->callback([options, &exit_code] {
    if (!options->map.empty()) {
      exit_code = build_from_map(*options);
      return;
    }
    if (!options->random && options->world.empty()) {
      throw UserError(
          "striate world: name a world to describe, say --random to draw one, or --from-map\n"
          "    e.g. striate world corridor_a, or striate world --random --seed 7");
    }
    if (options->random) {
      exit_code = draw(*options);
      return;
    }
    find_world(options->world);
    exit_code = describe_world(options->world);
  });
}

}  // namespace striate::app
