#include <fmt/format.h>

#include <memory>
#include <string>

#include "striate/agent/robot_settings.hpp"
#include "striate/app/command_line/found_file.hpp"
#include "striate/app/command_line/whole_number.hpp"
#include "striate/app/commands/commands.hpp"
#include "striate/app/commands/serve.hpp"
#include "striate/app/perceive_files.hpp"
#include "striate/app/pose_text.hpp"
#include "striate/base/user_error.hpp"
#include "striate/platform/simulator/render/renderer.hpp"
#include "striate/platform/simulator/start_place.hpp"
#include "striate/platform/simulator/world_reader.hpp"

namespace striate::app {
namespace {

/// Exposure control adapts from image to image; after these it has settled.
constexpr int kSettlingImages = 12;
/// By hand: half of the baseline, so that neither eye is within a thing.
constexpr double kEyesRoom_m = 0.06;

struct SimOptions {
  std::string world;
  std::string image;
  std::string at;
  std::string robot;
  // Down, so that the floor is seen from 2.1 m on (1.2 m high, 33 deg of view)
  double tilt_deg = -13.0;
  double pan_deg = 0.0;    // the head looks straight ahead
  int width_px = 0;        // 0: as the robot's file says
  std::uint64_t seed = 1;  // any; the first run of a series
  bool right_eye = false;
  ServeOptions serve;
};

int render(const SimOptions& options) {
  check_image_writable(options.image);
  const simulator::World world = simulator::load_world(options.world);
  const simulator::FloorPlan plan = simulator::build_floor_plan(world);
  const Pose2 along = options.at.empty() ? world.start : parse_pose(options.at);
  simulator::check_place(world, "--at", along, simulator::disc({0.0, 0.0}, kEyesRoom_m));
  agent::RobotSettings settings = agent::load_robot_settings(options.robot);
  if (options.width_px > 0) settings.camera.width_px = options.width_px;

  simulator::SceneState scene;
  const Pose2 base = plan.at(along.x_m, along.y_m);
  scene.robot = {base.x_m, base.y_m, wrap_angle(base.heading_rad + along.heading_rad)};
  scene.head = {radians(options.pan_deg), radians(options.tilt_deg)};
  for (const simulator::Stander& stander : world.standers) {
    const Pose2 place = plan.at(stander.at.x_m, stander.at.y_m);
    simulator::PersonState person;
    person.look = static_cast<int>(scene.people.size());
    person.pose = {place.x_m, place.y_m, place.heading_rad + stander.heading_rad};
    scene.people.push_back(person);
  }
  simulator::Renderer renderer(world, plan, settings.camera, options.seed);
  StereoFrame frame;
  for (int i = 0; i < kSettlingImages; ++i) {
    scene.frame = static_cast<std::uint64_t>(i);
    frame = renderer.image(scene);
  }
  const cv::Mat3b& image = options.right_eye ? frame.right : frame.left;
  write_picture(options.image, image);
  fmt::print("{}: {} x {} px, at {:.2f} m, {:.2f} m, {:.1f} deg of {}\n", options.image, image.cols,
             image.rows, along.x_m, along.y_m, degrees(along.heading_rad), world.name);
  return 0;
}

}  // namespace

void add_sim_command(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<SimOptions>();
  CLI::App* command =
      app.add_subcommand("sim",
                         "Renders what the robot's left eye sees at a place of a world, or serves "
                         "the simulated Pioneer to any ARCOS client.\n"
                         "Examples: striate sim corridor_a --picture view.png "
                         "--at \"12 m, 0.2 m, 5 deg\"\n"
                         "          striate sim corridor_a --serve");
  command->add_option("world", options->world, "the world file")->required();
  CLI::Option* image = command->add_option("--picture", options->image, "PNG to write");
  command
      ->add_option("--at", options->at,
                   "along, left of the middle, heading; without it the world's start")
      ->type_name("PLACE")
      ->needs(image);
  command->add_option("--robot", options->robot, "settings of the camera");
  command->add_option("--tilt-deg", options->tilt_deg, "of the head, up positive")
      ->needs(image)
      ->check(CLI::Range(-60.0, 60.0))
      ->capture_default_str();
  command->add_option("--pan-deg", options->pan_deg, "of the head, left positive")
      ->needs(image)
      ->check(CLI::Range(-120.0, 120.0))
      ->capture_default_str();
  command->add_option("--width-px", options->width_px, "of the image; 4:3")
      ->needs(image)
      ->check(CLI::Range(32, 2048));
  command->add_option("--seed", options->seed, "of the camera's noise")
      ->check(whole_number_from(0))
      ->capture_default_str();
  command->add_flag("--right", options->right_eye, "the right eye instead")->needs(image);
  add_serve_options(*command, options->serve);
  command->callback([options, &exit_code] {
    options->serve.check();
    find_world(options->world);
    find_robot(options->robot);
    if (options->serve.serves() && !options->image.empty()) {
      throw UserError("striate sim: --picture or --serve, not both");
    }
    if (options->serve.serves()) {
      options->serve.world = options->world;
      options->serve.robot = options->robot;
      options->serve.seed = options->seed;
      exit_code = serve(options->serve);
    } else if (options->image.empty()) {
      throw UserError("striate sim: say --picture FILE.png or --serve");
    } else {
      exit_code = render(*options);
    }
  });
}

}  // namespace striate::app
