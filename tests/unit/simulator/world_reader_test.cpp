#include "striate/platform/simulator/world_reader.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "striate/base/user_error.hpp"
#include "striate/platform/simulator/random.hpp"

namespace striate::simulator {
namespace {

using testing::HasSubstr;

/// Lines 1 to 3 of every world below; what a test adds begins on line 4.
const std::string kHead =
    "striate_world: 1\n"
    "name: test\n"
    "corridor: {length: 30 m, width: 2.4 m, height: 2.7 m}\n";

struct Told {
  int line;
  int column;
  std::string message;
  std::string hint;
};

void expect_diagnostics(const std::string& text, const std::vector<Told>& told) {
  config::Diagnostics diagnostics("test.yaml");
  (void)parse_world(text, diagnostics);
  ASSERT_EQ(diagnostics.list().size(), told.size()) << diagnostics.text();
  for (std::size_t i = 0; i < told.size(); ++i) {
    const config::Diagnostic& diagnostic = diagnostics.list()[i];
    EXPECT_EQ(diagnostic.place.line, told[i].line) << diagnostics.text();
    EXPECT_EQ(diagnostic.place.column, told[i].column) << diagnostics.text();
    EXPECT_THAT(diagnostic.message, HasSubstr(told[i].message));
    EXPECT_THAT(diagnostic.hint, HasSubstr(told[i].hint));
  }
}

void expect_diagnostic(const std::string& tail, const Told& told) {
  expect_diagnostics(kHead + tail, {told});
}

World expect_fine(const std::string& text) {
  config::Diagnostics diagnostics("test.yaml");
  World world = parse_world(text, diagnostics);
  EXPECT_TRUE(diagnostics.none()) << diagnostics.text();
  return world;
}

TEST(WorldReader, ReadsEveryPartOfTheLanguage) {
  const World world = expect_fine(R"(striate_world: 1
name: corridor_a
corridor: {length: 60 m, width: 2.4 m, height: 2.7 m}
widenings: [{from: 27 m, to: 34 m, width: 5.0 m}]
narrowings: [{from: 54 m, to: 55 m, width: 150 cm}]
pillars: [{at: [29.0 m, 0.9 m], diameter: 0.45 m}, {at: [32.0 m, -0.9 m]}]
wall_material: plaster
floor_material: linoleum
walls:
  - {side: left, from: 8 m, to: 20 m, material: blank_plaster}
  - {side: right, from: 10 m, to: 16 m, material: brick}
doors: [{side: right, at: 5 m}, {side: left, at: 24 m}]
windows: [{side: right, from: 44 m, to: 52 m}]
posters: [{side: left, at: 12 m, height: 1.5 m, size: [0.6 m, 0.9 m], image: poster_fish}]
lights: [{from: 0 m, to: 22 m, every: 4 m, level: 1.0}, {from: 22 m, to: 40 m, every: 6 m, level: 0.15}]
sun: {azimuth: 250 deg, elevation: 25 deg, level: 1.0}
obstacles:
  - {kind: table, at: [9.0 m, 0.5 m], turn: 10 deg}
  - {kind: cardboard_box, at: [17.0 m, -0.6 m], size: [0.5 m, 0.4 m, 0.6 m]}
  - {kind: table, at: [20.0 m, 0.5 m], name: the_desk}
objects:
  - {kind: book, name: red_book, at: [36.0 m, 0.9 m, 0.8 m]}
people:
  - {walk: [[40 m, 0.3 m], [5 m, 0.3 m]], speed: 1.2 m/s, from: 20 s}
  - {step_in_front: 2 per min, wait: 3 s}
  - {stand: [50 m, -0.5 m], heading: 90 deg}
start: {at: [1.0 m, 0 m], heading: 0 deg}
goal: {beyond: 58 m}
)");
  EXPECT_EQ(world.name, "corridor_a");
  EXPECT_DOUBLE_EQ(world.length_m, 60.0);
  ASSERT_EQ(world.widenings.size(), 2u);
  EXPECT_DOUBLE_EQ(world.widenings[1].width_m, 1.5);
  ASSERT_EQ(world.pillars.size(), 2u);
  EXPECT_DOUBLE_EQ(world.pillars[0].diameter_m, 0.45);
  ASSERT_EQ(world.walls.size(), 2u);
  EXPECT_EQ(world.walls[1].side, Side::right);
  EXPECT_EQ(world.walls[1].material, "brick");
  ASSERT_EQ(world.obstacles.size(), 3u);
  EXPECT_EQ(world.obstacles[0].name, "table_1");
  EXPECT_NEAR(world.obstacles[0].turn_rad, radians(10), 1e-12);
  EXPECT_EQ(world.obstacles[1].kind, ObstacleKind::cardboard_box);
  EXPECT_DOUBLE_EQ(world.obstacles[1].size_z_m, 0.6);
  EXPECT_EQ(world.obstacles[2].name, "the_desk");
  ASSERT_EQ(world.objects.size(), 1u);
  EXPECT_DOUBLE_EQ(world.objects[0].height_m, 0.8);
  ASSERT_TRUE(world.sun.has_value());
  EXPECT_NEAR(world.sun->azimuth_rad, radians(250), 1e-12);
  ASSERT_EQ(world.walks.size(), 1u);
  EXPECT_EQ(world.walks[0].points.size(), 2u);
  EXPECT_DOUBLE_EQ(world.walks[0].from_s, 20.0);
  ASSERT_EQ(world.steps_in_front.size(), 1u);
  EXPECT_NEAR(world.steps_in_front[0].per_minute, 2.0, 1e-12);
  ASSERT_EQ(world.standers.size(), 1u);
  EXPECT_NEAR(world.standers[0].heading_rad, radians(90), 1e-12);
  EXPECT_DOUBLE_EQ(world.goal_beyond_m, 58.0);
}

TEST(WorldReader, NeedsNoMoreThanNameAndLength) {
  const World world = expect_fine("striate_world: 1\nname: tiny\ncorridor: {length: 8 m}\n");
  EXPECT_DOUBLE_EQ(world.width_m, 2.4);
  EXPECT_DOUBLE_EQ(world.goal_beyond_m, 6.0);
}

TEST(WorldReader, DoesNotCareAboutTheOrderOfTheParts) {
  const World world = expect_fine(
      "goal: {beyond: 11 m}\npillars: [{at: [6 m, 2 m]}]\n"
      "widenings: [{from: 5 m, to: 8 m, width: 6 m}]\ncorridor: {length: 12 m}\n"
      "name: odd\nstriate_world: 1\n");
  EXPECT_EQ(world.pillars.size(), 1u);
}

TEST(WorldReader, SuggestsTheKeyThatWasMeant) {
  expect_diagnostic("obstcles: []\n",
                    {4, 1, "unknown key 'obstcles'", "did you mean 'obstacles'?"});
}

TEST(WorldReader, SuggestsTheKindThatWasMeant) {
  expect_diagnostic("obstacles:\n  - {kind: tabel, at: [9 m, 0 m]}\n",
                    {5, 12, "'tabel'", "did you mean 'table'?"});
}

TEST(WorldReader, SuggestsTheMaterialThatWasMeant) {
  expect_diagnostic("walls: [{side: left, from: 1 m, to: 2 m, material: brik}]\n",
                    {4, 52, "nothing that ships is called 'brik'", "did you mean 'brick'?"});
}

TEST(WorldReader, WantsUnits) {
  expect_diagnostic("doors: [{side: left, at: 5}]\n", {4, 26, "", "5 m"});
}

TEST(WorldReader, WantsFromBeforeTo) {
  expect_diagnostic("windows: [{side: right, from: 9 m, to: 4 m}]\n",
                    {4, 40, "'to' (4 m) must lie beyond 'from' (9 m)", ""});
}

TEST(WorldReader, KeepsStretchesWithinTheCorridor) {
  expect_diagnostic("lights: [{from: 0 m, to: 31 m}]\n",
                    {4, 26, "'to' (31 m) lies outside the corridor", "0 m to 30 m"});
}

TEST(WorldReader, KeepsThingsBetweenTheWalls) {
  expect_diagnostic("obstacles:\n  - {kind: bin, at: [9 m, 1.3 m]}\n",
                    {5, 21, "y = 1.3 m lies outside the corridor", "-1.2 m and 1.2 m"});
  expect_diagnostic("obstacles:\n  - {kind: bin, at: [9 m, 1.15 m]}\n",
                    {5, 21, "'bin_1' stands in a wall", "middle"});
  expect_diagnostic("pillars: [{at: [31 m, 0 m]}]\n", {4, 16, "x = 31 m lies outside", "30 m"});
}

TEST(WorldReader, LetsAThingStandFlushWithAWall) {
  expect_fine(kHead + "obstacles: [{kind: box, at: [9 m, 0.95 m], size: [0.5 m, 0.5 m, 0.5 m]}]\n");
}

TEST(WorldReader, KeepsTheStartFree) {
  expect_diagnostic("obstacles: [{kind: chair, at: [1.2 m, 0.2 m]}]\nstart: {at: [1 m, 0 m]}\n",
                    {5, 13, "the start overlaps chair_1", "0.3 m back"});
  expect_diagnostic("start: {at: [0.2 m, 0 m]}\n", {4, 13, "the start overlaps a wall", ""});
}

TEST(WorldReader, TellsOtherWidthsThatAreNone) {
  expect_diagnostic("widenings: [{from: 5 m, to: 8 m, width: 2 m}]\n",
                    {4, 41, "a widening of 2 m in a corridor of 2.4 m", "'narrowings'"});
  expect_diagnostic(
      "widenings: [{from: 5 m, to: 8 m, width: 4 m}, {from: 7 m, to: 9 m, width: 3 m}]\n",
      {4, 54, "overlaps the other width from 5 m to 8 m", ""});
}

TEST(WorldReader, TellsTurnsThatDoNotFit) {
  expect_diagnostic("turns: [{at: 0.5 m, angle: 90 deg}]\n",
                    {4, 14, "needs 1.2 m of corridor", ""});
  expect_diagnostic("turns: [{at: 15 m, angle: 170 deg}]\n", {4, 27, "", ""});
  expect_diagnostic(
      "turns: [{at: 7 m, angle: 90 deg}, {at: 12 m, angle: 90 deg}, {at: 17 m, angle: 90 deg}]\n",
      {4, 67, "the corridor crosses itself", ""});
}

TEST(WorldReader, TellsWhatAPersonCannotDo) {
  expect_diagnostic("people: [{walk: [[5 m, 0 m]]}]\n", {4, 17, "two points or more", "[[40 m"});
  expect_diagnostic("people: [{walk: [[5 m, 0 m], [8 m, 2 m]]}]\n", {4, 17, "y = 2 m", ""});
  expect_diagnostic("people: [{speed: 1 m/s}]\n", {4, 10, "what does this person do?", "walk"});
  expect_diagnostic("people: [{stand: [5 m, 0 m], step_in_front: 2 per min}]\n",
                    {4, 10, "a person does one thing", ""});
  expect_diagnostic(
      "obstacles: [{kind: box, at: [5 m, 0 m], size: [5 m, 2.4 m, 1 m]}]\n"
      "people: [{stand: [5 m, 0.3 m]}]\n",
      {5, 18, "there is no room for a person", "0.25 m"});
}

TEST(WorldReader, MovesAPersonToTheNearestPlaceWithRoom) {
  config::Diagnostics diagnostics("test.yaml");
  const World world =
      parse_world(kHead +
                      "obstacles: [{kind: box, at: [5 m, 0 m], size: [0.5 m, 0.5 m, 0.5 m]}]\n"
                      "people: [{stand: [5 m, 0.3 m]}, {stand: [9 m, 1.15 m]}]\n",
                  diagnostics);
  ASSERT_TRUE(diagnostics.none()) << diagnostics.text();
  EXPECT_GE(world.standers.at(0).at.y_m, 0.5);
  EXPECT_LT(world.standers.at(0).at.y_m, 0.6);
  EXPECT_LE(world.standers.at(1).at.y_m, 0.95);
}

TEST(WorldReader, TellsAGoalThatCannotBeReached) {
  expect_diagnostic("goal: {beyond: 29.9 m}\n", {4, 16, "touch the end wall", "29.79 m"});
  expect_diagnostic("goal: {beyond: 0.5 m}\n", {4, 16, "must lie beyond the start", ""});
}

TEST(WorldReader, TellsDoorsThatOverlapAndLetsWindowsMakeWay) {
  expect_fine(kHead +
              "doors: [{side: left, at: 5 m}]\nwindows: [{side: left, from: 4 m, to: 7 m}]\n");
  expect_diagnostic("doors: [{side: left, at: 5 m}, {side: left, at: 5.5 m}]\n",
                    {4, 49, "overlaps the door at 5 m", ""});
}

TEST(WorldReader, TellsAnImageFileThatIsMissing) {
  expect_diagnostic("posters: [{side: left, at: 5 m, image: pictures/none.png}]\n",
                    {4, 40, "there is no file 'pictures/none.png'", "world file's folder"});
}

TEST(WorldReader, TellsAnImageFileThatIsNoImage) {
  const std::string folder = testing::TempDir();
  std::ofstream(folder + "/no_image.png") << "hello";
  config::Diagnostics diagnostics(folder + "/test.yaml");
  (void)parse_world(kHead + "wall_material: ./no_image.png\n", diagnostics);
  ASSERT_EQ(diagnostics.list().size(), 1u) << diagnostics.text();
  EXPECT_EQ(diagnostics.list()[0].place.column, 16);
  EXPECT_THAT(diagnostics.list()[0].message, HasSubstr("is no image that can be read"));
}

TEST(WorldReader, TellsWhatIsMissing) {
  expect_diagnostics("striate_world: 1\n",
                     {{1, 1, "needs 'name'", ""}, {1, 1, "needs 'corridor'", ""}});
  expect_diagnostics("", {{0, 0, "empty", ""}});
}

TEST(WorldReader, TellsAllDiagnosticsInOnePass) {
  config::Diagnostics diagnostics("test.yaml");
  (void)parse_world(kHead +
                        "lights: [{from: 3 m, to: 1 m}]\n"
                        "doors: [{side: lft, at: 5 m}]\n"
                        "obstacles:\n"
                        "  - {kind: bin, at: [9 m, 0 m], colour: red}\n"
                        "  - {kind: bin, at: [9 m, 3 m]}\n"
                        "goal: {beyond: 40 m}\n",
                    diagnostics);
  EXPECT_EQ(diagnostics.list().size(), 5u) << diagnostics.text();
  const std::string text = diagnostics.text();
  for (const char* place : {"test.yaml:4:26:", "test.yaml:5:16:", "test.yaml:7:33:",
                            "test.yaml:8:21:", "test.yaml:9:16:"}) {
    EXPECT_THAT(text, HasSubstr(place));
  }
}

TEST(WorldReader, SurvivesDamagedFiles) {
  std::ifstream stream(STRIATE_SOURCE_DIR "/config/worlds/corridor_c.yaml");
  const std::string whole((std::istreambuf_iterator<char>(stream)), {});
  ASSERT_GT(whole.size(), 1000u);
  const Random random(1, Purpose::walk);
  const std::string spice = "[]{}:,- #\n\"'0129-.mdegx&*!|";
  int refused = 0;
  for (std::uint64_t trial = 0; trial < 400; ++trial) {
    std::string text = whole;
    for (std::uint64_t damage = 0; damage < 1 + trial % 4; ++damage) {
      const std::uint64_t draw = random.bits(10 * trial + damage);
      text[draw % text.size()] = spice[(draw >> 32) % spice.size()];
    }
    config::Diagnostics diagnostics("damaged.yaml");
    (void)parse_world(text, diagnostics);
    refused += !diagnostics.none();
  }
  EXPECT_GT(refused, 100);
}

TEST(WorldReader, LoadingAMissingFileIsAUsersDiagnostic) {
  EXPECT_THROW((void)load_world("/nowhere/world.yaml"), UserError);
}

}  // namespace
}  // namespace striate::simulator
