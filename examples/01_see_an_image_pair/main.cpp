// One image pair in, one percept out: what stands in the way, how far, and where the corridor
// leads.
#include <cmath>
#include <cstdio>
#include <exception>
#include <opencv2/imgcodecs.hpp>
#include <string>

#include "striate/agent/pictures/overview.hpp"
#include "striate/config/diagnostics.hpp"
#include "striate/perception/perception.hpp"
#include "striate/platform/simulator/render/renderer.hpp"
#include "striate/platform/simulator/world_reader.hpp"

namespace {

// 3 m before the robot, which starts at 1 m, the middle of a box; its near side is 0.2 m nearer. 2
// m farther, to the left, a pillar.
constexpr const char* kWorld = R"(striate_world: 1
name: a box in the way
corridor: {length: 20 m, width: 2.4 m, height: 2.7 m}
walls: [{side: left, from: 2 m, to: 9 m, material: brick}]
posters: [{side: right, at: 5 m, image: poster_map}]
lights: [{from: 0 m, to: 20 m, every: 4 m, level: 1}]
obstacles:
  - {kind: cardboard_box, at: [4 m, -0.3 m], size: [0.4 m, 0.5 m, 0.6 m]}
  - {kind: cylinder, at: [6 m, 0.8 m], size: [0.4 m, 0.4 m, 1.2 m]}
start: {at: [1 m, 0 m]}
goal: {beyond: 18 m}
)";
constexpr double kBox_m = 2.8;         // from the robot's axle to the near side of the box
constexpr double kTolerance_m = 0.15;  // of the distance that is seen

/// The image pair that the robot's stereo head takes at the start of the world. Your own cameras
/// fill the same struct: two rectified images, focal length, image centre, baseline.
striate::StereoFrame take_image_pair() {
  namespace simulator = striate::simulator;
  striate::config::Diagnostics mistakes("the world");
  const simulator::World world = simulator::parse_world(kWorld, mistakes);
  mistakes.throw_if_any();
  const simulator::FloorPlan plan = simulator::build_floor_plan(world);
  simulator::Renderer renderer(world, plan, simulator::CameraSettings{}, 1);
  simulator::SceneState scene;
  scene.robot = world.start;
  scene.head.tilt_rad = striate::RobotDescription{}.resting_tilt_rad;
  striate::StereoFrame frame;
  for (; scene.frame < 12; ++scene.frame) frame = renderer.image(scene);  // the exposure settles
  frame.head = scene.head;
  return frame;
}

}  // namespace

int main(int count, char** words) try {
  const std::string folder = count > 1 ? words[1] : ".";
  const striate::StereoFrame frame = take_image_pair();
  const striate::RobotDescription robot;
  striate::perception::Perception perception({}, robot);
  const striate::perception::Percept percept = perception.see(frame);

  for (const striate::perception::Obstacle& thing : percept.obstacles) {
    std::printf("%.2f m ahead, %+.0f deg: something %.2f m wide and %.2f m high\n",
                thing.distance_m, striate::degrees(thing.bearing_rad), thing.width_m,
                thing.height_m);
  }
  std::printf("the corridor leads %+.1f deg from straight ahead; walls %.2f m left, %.2f m right\n",
              striate::degrees(percept.corridor.heading_rad), percept.corridor.left_m,
              percept.corridor.right_m);
  const std::string picture = folder + "/percept.png";
  if (!cv::imwrite(picture, striate::agent::pictures::draw_overview(frame, percept, robot)))
    return 1;
  std::printf("%s shows all of it\n", picture.c_str());
  const bool seen = !percept.obstacles.empty() &&
                    std::abs(percept.obstacles.front().distance_m - kBox_m) < kTolerance_m;
  return seen && percept.corridor.valid ? 0 : 1;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}
