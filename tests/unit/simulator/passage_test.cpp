#include "striate/platform/simulator/passage.hpp"

#include <gtest/gtest.h>

#include <set>

#include "striate/platform/simulator/world_reader.hpp"

namespace striate::simulator {
namespace {

World parsed_passage_world(const std::string& rest) {
  config::Diagnostics diagnostics("passage.yaml");
  World world = parse_world(
      "striate_world: 1\nname: passage\ncorridor: {length: 20 m, width: 2.4 m}\n" + rest,
      diagnostics);
  EXPECT_TRUE(diagnostics.none()) << diagnostics.text();
  return world;
}

Passage passage_of(const std::string& rest) {
  const World world = parsed_passage_world(rest);
  return widest_passage(world, build_floor_plan(world));
}

TEST(WidestPassage, OfAnEmptyCorridorIsTheCorridor) {
  // At the start, 1 m before the wall behind it, a disc of 2 m has room.
  EXPECT_NEAR(passage_of("").width_m, 2.0, 1e-9);
  EXPECT_NEAR(passage_of("start: {at: [3 m, 0 m]}").width_m, 2.4, 0.05);
}

TEST(WidestPassage, IsTheWiderGapBesideAThing) {
  const Passage passage = passage_of(
      "obstacles: [{kind: box, name: crate, at: [10 m, 0.4 m], size: [1 m, 0.6 m, 1 m]}]");
  EXPECT_NEAR(passage.width_m, 1.3, 1e-9);  // from -1.2 m to 0.1 m
  EXPECT_EQ((std::set<std::string>{passage.one, passage.other}),
            (std::set<std::string>{"crate", "wall"}));
  EXPECT_NEAR(passage.at.y_m, -0.55, 1e-9);
}

TEST(WidestPassage, IsAFrame) {
  const Passage passage = passage_of("narrowings: [{from: 9 m, to: 9.2 m, width: 0.8 m}]");
  EXPECT_NEAR(passage.width_m, 0.8, 1e-9);
  EXPECT_NEAR(passage.at.x_m, 9.1, 0.11);
}

TEST(WidestPassage, GoesRoundTheCornerBetweenThingsThatAreFarApartAlongTheWay) {
  // Across the corridor 0.4 m are free of each; between them 1 m.
  const Passage passage = passage_of(
      "obstacles:\n"
      "  - {kind: box, at: [9.5 m, 0.2 m], size: [0.4 m, 2 m, 1 m]}\n"
      "  - {kind: box, at: [11 m, -0.2 m], size: [0.4 m, 2 m, 1 m]}\n");
  EXPECT_NEAR(passage.width_m, 0.4, 1e-9);
  // Slanted: the nearest corners decide, not what each leaves by itself.
  const Passage slanted = passage_of(
      "obstacles:\n"
      "  - {kind: box, at: [9.5 m, 0.6 m], size: [0.4 m, 1.2 m, 1 m]}\n"
      "  - {kind: box, at: [10.2 m, -0.6 m], size: [0.4 m, 1.2 m, 1 m]}\n");
  EXPECT_NEAR(slanted.width_m, 0.3, 1e-9);
}

TEST(WidestPassage, IsNoneWhereThingsCloseTheCorridor) {
  EXPECT_EQ(
      passage_of("obstacles: [{kind: box, at: [9 m, 0 m], size: [0.4 m, 2.4 m, 1 m]}]").width_m,
      0.0);
}

TEST(WidestPassage, CountsALateThingAndAPersonWhoStands) {
  EXPECT_NEAR(passage_of("obstacles: [{kind: box, at: [9 m, 0 m], size: [1 m, 1 m, 1 m], "
                         "appears_after: 3 m}]")
                  .width_m,
              0.7, 1e-9);
  const Passage passage = passage_of("people: [{stand: [9 m, 0 m]}]");
  EXPECT_NEAR(passage.width_m, 0.95, 1e-9);
}

TEST(WidestPassage, LooksAtTheWayAloneNotAtBlindEnds) {
  // Behind the start and beyond the goal all may be closed.
  EXPECT_GT(passage_of("start: {at: [5 m, 0 m]}\ngoal: {beyond: 12 m}\n"
                       "obstacles:\n"
                       "  - {kind: box, at: [2 m, 0 m], size: [0.4 m, 2.4 m, 1 m]}\n"
                       "  - {kind: box, at: [16 m, 0 m], size: [0.4 m, 2.4 m, 1 m]}\n")
                .width_m,
            2.0);
}

TEST(WidestPassage, SeesARingOfThingsRoundTheStart) {
  EXPECT_NEAR(passage_of("start: {at: [5 m, 0 m]}\n"
                         "obstacles:\n"
                         "  - {kind: box, at: [6.2 m, 0 m], size: [0.2 m, 2 m, 1 m]}\n"
                         "  - {kind: box, at: [3.8 m, 0 m], size: [0.2 m, 2 m, 1 m]}\n"
                         "  - {kind: box, at: [5 m, 0.9 m], size: [2.2 m, 0.2 m, 1 m]}\n")
                  .width_m,
              0.2, 1e-9);
}

TEST(WidestPassage, GoesThroughBends) {
  EXPECT_NEAR(passage_of("turns: [{at: 8 m, angle: 90 deg}, {at: 14 m, angle: -60 deg}]\n"
                         "start: {at: [3 m, 0 m]}\n"
                         "obstacles: [{kind: box, at: [10 m, -0.6 m], size: [1 m, 1.2 m, 1 m]}]")
                  .width_m,
              1.2, 1e-9);
}

}  // namespace
}  // namespace striate::simulator
