#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "striate/platform/simulator/clearance_map.hpp"
#include "striate/platform/simulator/judge.hpp"
#include "striate/platform/simulator/passage.hpp"
#include "striate/platform/simulator/physics.hpp"
#include "striate/platform/simulator/range_finders.hpp"
#include "striate/platform/simulator/render/stage.hpp"
#include "striate/platform/simulator/simulated_pioneer.hpp"
#include "striate/platform/simulator/world_description.hpp"
#include "striate/platform/simulator/world_reader.hpp"
#include "striate/platform/simulator/world_writer.hpp"
#include "tests/unit/simulator/fake_images.hpp"
#include "tests/unit/simulator/render_world.hpp"

namespace striate::simulator {
namespace {

using testing::HasSubstr;

std::string with_parts(const std::string& parts) {
  return "striate_world: 1\nname: parts\ncorridor: {length: 12 m, width: 2.4 m}\n"
         "lights: [{from: 0 m, to: 12 m}]\n" +
         parts;
}

World read_parts(const std::string& parts) {
  config::Diagnostics diagnostics("parts.yaml");
  World world = parse_world(with_parts(parts), diagnostics);
  EXPECT_TRUE(diagnostics.none()) << diagnostics.text();
  return world;
}

std::string mistakes_in(const std::string& parts) {
  config::Diagnostics diagnostics("parts.yaml");
  (void)parse_world(with_parts(parts), diagnostics);
  return diagnostics.text();
}

constexpr const char* kStairsAhead =
    "obstacles: [{kind: stairs, at: [6 m, 0 m], size: [1.6 m, 1 m, 1.4 m]}]\n";
constexpr const char* kGlassAhead =
    "obstacles: [{kind: glass, at: [6 m, 0 m], turn: 90 deg, size: [1.4 m, 0.05 m, 2 m]}]\n";

TEST(BuildingParts, AreReadWrittenAndDescribed) {
  const World world = read_parts(
      "floor_patches: [{at: [5 m, 0.2 m], size: [2 m, 1.5 m], turn: 20 deg, material: wet},\n"
      "                {at: [8 m, 0 m], size: [1 m, 1 m], material: carpet}]\n"
      "eyes: {tilt: 0.5 deg, rows: -0.4 px, rolling_shutter: 20 ms, dirt: 5 %}\n"
      "obstacles: [{kind: wall, at: [9 m, 0.7 m], size: [2 m, 0.6 m, 2.7 m]}]\n");
  ASSERT_EQ(world.floor_patches.size(), 2U);
  EXPECT_EQ(world.floor_patches[0].material, "wet");
  EXPECT_DOUBLE_EQ(world.eyes.rolling_shutter_s, 0.02);
  const std::string text = world_as_yaml(world);
  config::Diagnostics diagnostics("parts.yaml");
  const World again = parse_world(text, diagnostics);
  EXPECT_TRUE(diagnostics.none()) << diagnostics.text();
  EXPECT_EQ(world_as_yaml(again), text);
  EXPECT_NEAR(again.eyes.tilt_rad, world.eyes.tilt_rad, 1e-9);
  EXPECT_DOUBLE_EQ(again.eyes.rows_px, world.eyes.rows_px);
  const FloorPlan plan = build_floor_plan(world);
  const std::string words = describe_world(world, plan, widest_passage(world, plan));
  EXPECT_THAT(words, HasSubstr("2 patches"));
  EXPECT_THAT(words, HasSubstr("tilt 0.5 deg, rows -0.4 px"));
}

TEST(BuildingParts, MistakesAreToldWithTheirPlaces) {
  EXPECT_THAT(mistakes_in("obstacles: [{kind: stairs, at: [6 m, 0 m], from: 5 s}]\n"),
              HasSubstr("parts.yaml:5:50: error: stairs are there from the beginning"));
  EXPECT_THAT(mistakes_in("floor_patches: [{at: [6 m, 0 m], size: [1 m, 1 m], material: wett}]\n"),
              HasSubstr("nothing that ships is called 'wett'"));
  EXPECT_THAT(mistakes_in("floor_patches: [{at: [60 m, 0 m], size: [1 m, 1 m], material: wet}]\n"),
              HasSubstr("x = 60 m lies outside the corridor"));
  EXPECT_THAT(mistakes_in("walls: [{side: left, from: 1 m, to: 2 m, material: wet}]\n"),
              HasSubstr("nothing that ships is called 'wet'"))
      << "water hangs on no wall";
  EXPECT_THAT(mistakes_in("obstacles: [{kind: box, at: [6 m, 0 m], size: [9 m, 1 m, 1 m]}]\n"),
              HasSubstr("9 m"))
      << "only a wall may be so long";
  EXPECT_THAT(mistakes_in("eyes: {tilt: 20 deg}\n"), HasSubstr("parts.yaml:5:"));
  EXPECT_THAT(mistakes_in("eyes: {blur: 1}\n"), HasSubstr("blur"));
}

const Judge& drive_on(SimulatedPioneer& robot) {
  Senses senses;
  do {
    robot.send({.forward_m_s = 0.5});
  } while (robot.sense(senses));
  return robot.judge();
}

TEST(BuildingParts, ABaseThatDrivesOverAnEdgeHasFallen) {
  SimulatedPioneer robot(read_parts(kStairsAhead), 1, exact_start(), nullptr);
  const Judge& judge = drive_on(robot);
  EXPECT_EQ(judge.outcome(), Verdict::collided);
  ASSERT_EQ(judge.collisions().size(), 1U);
  EXPECT_EQ(judge.collisions()[0].hit, "drop of stairs_1");
  // The front hangs over first; it goes down when the wheels are at the edge.
  EXPECT_NEAR(judge.collisions()[0].along_m, 5.2, 0.02);
}

TEST(BuildingParts, WhoPassesBesideStairsFallsNot) {
  World world =
      read_parts("obstacles: [{kind: stairs, at: [6 m, 0.7 m], size: [1.6 m, 0.9 m, 1.4 m]}]\n");
  world.start.y_m = -0.4;
  SimulatedPioneer robot(world, 1, exact_start(), nullptr);
  EXPECT_EQ(drive_on(robot).outcome(), Verdict::reached_goal);
}

TEST(BuildingParts, StairsAreInTheWayOfPeopleAndOfThePassage) {
  const World world = read_parts(kStairsAhead);
  const FloorPlan plan = build_floor_plan(world);
  EXPECT_NEAR(widest_passage(world, plan).width_m, 0.7, 1e-9);
  EXPECT_EQ(ClearanceMap(world, plan).at({6.0, 0.0}), 0.0);
}

double ahead_m(const World& world, Beam beam) {
  const Physics physics(world, build_floor_plan(world), RobotDescription{}, {3.0, 0.0, 0.0}, 0);
  return physics.ray({3.3, 0.0}, 0.0, 20.0, beam).distance_m;
}

TEST(BuildingParts, RangeFindersSeeNothingOfStairs) {
  const World world = read_parts(kStairsAhead);
  EXPECT_NEAR(ahead_m(world, Beam::light), 8.7, 0.01) << "the end wall";
  EXPECT_NEAR(ahead_m(world, Beam::sound), 8.7, 0.01);
}

TEST(BuildingParts, GlassThrowsBackSoundAndLetsTheLaserThrough) {
  const World world = read_parts(kGlassAhead);
  EXPECT_NEAR(ahead_m(world, Beam::light), 8.7, 0.01) << "the end wall";
  EXPECT_NEAR(ahead_m(world, Beam::sound), 2.675, 0.01);
  SimulatedPioneer robot(world, 1, exact_start(), nullptr);
  ASSERT_FALSE(drive_on(robot).collisions().empty());
  EXPECT_EQ(robot.judge().collisions()[0].hit, "glass_1");
  const Physics physics(world, build_floor_plan(world), RobotDescription{}, {3.0, 0.0, 0.0}, 0);
  EXPECT_NEAR(physics.ray({3.3, 0.67}, 0.0, 20.0, Beam::light).distance_m, 2.675, 0.01)
      << "the frame's post";
}

TEST(BuildingParts, AnInnerWallThrowsSoundAwayAsWallsDo) {
  const World world =
      read_parts("obstacles: [{kind: wall, at: [6 m, 0 m], size: [8 m, 1 m, 2 m]}]\n");
  const Physics physics(world, build_floor_plan(world), RobotDescription{}, {1.0, 0.0, 0.0}, 0);
  EXPECT_TRUE(physics.ray({1.2, 0.0}, 0.0, 20.0, Beam::sound).smooth);
  EXPECT_NEAR(physics.ray({1.2, 0.0}, 0.0, 20.0, Beam::sound).distance_m, 0.8, 0.01);
}

/// Depth in the middle of the image and some pixels below it.
float depth_below(const World& world, int below_px) {
  Renderer renderer(world, build_floor_plan(world), test::clean_camera(), 1);
  SceneState state = test::standing_at(3.0, 0.0);
  state.head.tilt_rad = radians(-20);
  const cv::Mat1f depth = renderer.true_depth(state, 160);
  return depth(depth.rows / 2 + below_px, depth.cols / 2);
}

TEST(BuildingParts, TheEyesLookDownIntoTheStairwell) {
  const float floor = depth_below(read_parts(""), 0);
  EXPECT_NEAR(floor, 1.2 / std::sin(radians(20)), 0.1);
  EXPECT_GT(depth_below(read_parts(kStairsAhead), 0), floor + 0.3F);
  EXPECT_NEAR(depth_below(read_parts(kStairsAhead), 50), depth_below(read_parts(""), 50), 1e-3)
      << "before the edge there is floor";
}

TEST(BuildingParts, TheEyesLookThroughGlassAndSeeItsFrame) {
  const World world = read_parts(kGlassAhead);
  Renderer renderer(world, build_floor_plan(world), test::clean_camera(), 1);
  const cv::Mat1f depth = renderer.true_depth(test::standing_at(3.0, 0.0), 160);
  const int row = depth.rows / 2;
  EXPECT_GT(depth(row, depth.cols / 2), 8.0F) << "the end wall";
  float nearest = 100.0F;
  for (int u = 25; u < depth.cols - 25; ++u) nearest = std::min(nearest, depth(row, u));
  EXPECT_NEAR(nearest, 2.975 - test::clean_camera().forward_of_axle_m, 0.02)
      << "a post; the walls are seen farther out";
}

TEST(BuildingParts, NoLampHangsWithinAnInnerWall) {
  const World open = read_parts("");
  const World walled =
      read_parts("obstacles: [{kind: wall, at: [6 m, 0 m], size: [2 m, 1 m, 2.7 m]}]\n");
  const auto lamps = [](const World& world) {
    return render::build_stage(world, build_floor_plan(world)).lamps.size();
  };
  EXPECT_EQ(lamps(open), 3U);  // at 2 m, 6 m and 10 m
  EXPECT_EQ(lamps(walled), 2U);
}

TEST(BuildingParts, ASitterTakesAChairAndHisLegsAndOneWhoCarriesNoMoreThanHimself) {
  const World world = read_parts(
      "obstacles: [{kind: sitter, at: [6 m, 0 m]}]\n"
      "people: [{walk: [[10 m, 0 m], [8 m, 0 m]], carries: true}]\n");
  EXPECT_TRUE(world.walks.at(0).carries);
  EXPECT_NEAR(widest_passage(world, build_floor_plan(world)).width_m, 0.95, 1e-9);
  const Physics physics(world, build_floor_plan(world), RobotDescription{}, {3.0, 0.0, 0.0}, 0);
  EXPECT_NEAR(physics.ray({9.0, 0.115}, kPi, 20.0, Beam::light).distance_m,
              9.0 - (6.0 + 0.4 * 0.76 + 0.055), 0.01)
      << "a shin";
  EXPECT_NEAR(physics.ray({9.0, 0.0}, kPi, 20.0, Beam::light).distance_m, 9.0, 0.01)
      << "between the legs";
  // What is carried is drawn before the chest, nearer to the eyes than the chest.
  const auto nearest_of = [&](bool carries) {
    Renderer renderer(read_parts(""), build_floor_plan(world), test::clean_camera(), 1);
    SceneState state = test::standing_at(3.0, 0.0);
    PersonState person;
    person.pose = {6.0, 0.0, kPi};
    person.carries = carries;
    state.people = {person};
    const cv::Mat1f depth = renderer.true_depth(state, 160);
    return depth(depth.rows / 2 + 2, depth.cols / 2);
  };
  EXPECT_LT(nearest_of(true), nearest_of(false) - 0.05F);
  EXPECT_GT(nearest_of(true), 6.0F - 0.25F * 1.05F - 3.0F - RobotDescription{}.camera_forward_m);
}

TEST(BuildingParts, AWetFloorIsDarkerAndMirrors) {
  const auto picture = [](const std::string& patch, const LightRow& lamps) {
    World world = read_parts("floor_material: concrete\n" + patch);
    world.lights = {lamps};
    Renderer renderer(world, build_floor_plan(world), test::clean_camera(), 1);
    SceneState state = test::standing_at(3.0, 0.0);
    state.head.tilt_rad = radians(-20);
    return renderer.image(state).left.clone();
  };
  const std::string wet = "floor_patches: [{at: [6 m, 0 m], size: [3 m, 2.4 m], material: wet}]\n";
  // One lamp, behind the eyes: what lies before them mirrors the dark end of the corridor.
  const LightRow behind{0.0, 3.0, 4.0, 1.0};
  const cv::Rect ahead(60, 50, 40, 20);
  EXPECT_LT(test::mean_of(picture(wet, behind), ahead),
            test::mean_of(picture("", behind), ahead) - 5.0);
  // Lamps all along: the water shows the one at 10 m where light falls in as it is thrown back.
  const LightRow along{0.0, 12.0, 4.0, 1.0};
  const auto brightest = [](const cv::Mat3b& image) {
    double high = 0.0;
    cv::minMaxLoc(image(cv::Rect(60, 80, 40, 25)).clone().reshape(1), nullptr, &high);
    return high;
  };
  EXPECT_GT(brightest(picture(wet, along)), brightest(picture("", along)) + 30.0);
}

}  // namespace
}  // namespace striate::simulator
