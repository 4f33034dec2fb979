#include <numbers>

#include "render_world.hpp"

namespace striate::simulator::test {
namespace {

/// Windows on the right, sun shining in from there.
World sunny_corridor(double sun_level) {
  World world = bright_corridor();
  world.lights[0].level = 0.3;
  world.windows = {{Side::right, 3.0, 9.0}};
  world.sun = Sun{radians(-90.0), radians(35.0), sun_level};
  return world;
}

double brightest_part_of_left_wall(const World& world, const CameraSettings& camera) {
  Renderer renderer(world, build_floor_plan(world), camera, 1);
  SceneState state = standing_at(6.0, -0.9, 90.0);
  state.head.tilt_rad = radians(-20.0);
  const cv::Mat3b image = renderer.image(state).left;
  double low = 0.0;
  double high = 0.0;
  cv::Mat one;
  cv::extractChannel(image, one, 1);
  cv::minMaxLoc(one, &low, &high);
  return high / cv::mean(one)[0];
}

TEST(Renderer, SunMakesBrightPatchesThroughWindows) {
  const double with_sun = brightest_part_of_left_wall(sunny_corridor(1.0), clean_camera());
  const double without = brightest_part_of_left_wall(sunny_corridor(0.0), clean_camera());
  EXPECT_GT(with_sun, 1.7);
  EXPECT_LT(without, 1.6);
}

TEST(Renderer, KnowsTheLightAtAPlace) {
  World world = bright_corridor();
  world.length_m = 40.0;
  world.lights = {{0.0, 16.0, 4.0, 1.0}};
  const Renderer renderer(world, build_floor_plan(world), clean_camera(), 1);
  EXPECT_GT(renderer.light_level({8.0, 0.0}), 0.75);
  EXPECT_LT(renderer.light_level({36.0, 0.0}), 0.03);
  EXPECT_GE(renderer.light_level({36.0, 0.0}), 0.0);
}

TEST(Renderer, BlankPlasterIsNearlyBlankAndPlasterIsNot) {
  const auto roughness = [](const char* material) {
    World world = bright_corridor();
    world.wall_material = material;
    CameraSettings camera = clean_camera(320);
    camera.vignetting = 0.0;
    Renderer renderer(world, build_floor_plan(world), camera, 1);
    const cv::Mat3b image = renderer.image(standing_at(6.0, 0.0, 90.0)).left;
    // Departure from the mean of the neighbours: texture, not shading.
    cv::Mat green;
    cv::extractChannel(image, green, 1);
    cv::Mat1f grey;
    green.convertTo(grey, CV_32F);
    double sum = 0.0;
    for (int y = 60; y < 180; ++y) {
      for (int x = 60; x < 260; ++x) {
        const double around =
            (grey(y - 3, x) + grey(y + 3, x) + grey(y, x - 3) + grey(y, x + 3)) / 4.0;
        sum += std::abs(grey(y, x) - around);
      }
    }
    return sum / (120.0 * 200.0);
  };
  const double blank = roughness("blank_plaster");
  EXPECT_LT(blank, 0.2);
  EXPECT_GT(roughness("plaster"), 1.5 * blank);
  EXPECT_GT(roughness("brick"), 5.0);
}

TEST(Renderer, APersonShadesTheFloorAroundHim) {
  const World world = bright_corridor();
  Renderer renderer(world, build_floor_plan(world), clean_camera(), 1);
  SceneState state = standing_at(4.0, 0.0);
  state.head.tilt_rad = radians(-25.0);
  const cv::Mat3b before = renderer.image(state).left.clone();
  PersonState person;
  person.pose = {6.4, 0.7, 0.0};
  state.people = {person};
  const cv::Mat1f depth = renderer.true_depth(state, 160);
  const cv::Mat3b after = renderer.image(state).left;
  // Floor just right of the feet: the same depth as without him, and darker.
  int darker = 0;
  state.people.clear();
  const cv::Mat1f floor = renderer.true_depth(state, 160);
  for (int y = 0; y < 120; ++y) {
    for (int x = 0; x < 160; ++x) {
      if (depth(y, x) == floor(y, x) && after(y, x)[1] + 12 < before(y, x)[1]) ++darker;
    }
  }
  EXPECT_GT(darker, 60);
}

}  // namespace
}  // namespace striate::simulator::test
