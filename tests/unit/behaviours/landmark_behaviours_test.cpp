#include <gtest/gtest.h>

#include "striate/behaviours/approach_landmark.hpp"
#include "striate/behaviours/go_to.hpp"
#include "striate/behaviours/return_to_start.hpp"
#include "striate/behaviours/seek_landmark.hpp"
#include "striate/behaviours/traverse_corridor.hpp"
#include "tests/reference/flat_landmarks.hpp"
#include "tests/reference/flat_layouts.hpp"

namespace striate::behaviours {
namespace {

/// A corridor from -1.5 to `end_m`, shut at both ends.
flat::Layout shut_corridor(double end_m) {
  flat::Layout layout;
  flat::Random random(1);
  flat::add_walls(layout, -1.5, end_m, flat::kHalfCorridor_m, random, 0.0);
  for (const double x : {-1.5, end_m}) {
    layout.faces.push_back(
        {{x, -flat::kHalfCorridor_m}, {x, flat::kHalfCorridor_m}, 0.0, 2.7, false});
  }
  layout.goal_x_m = 1e6;
  return layout;
}

/// A stand beside the wall, and the book on it.
flat::Landmark stand_with_book(flat::Layout& layout, double x_m, double side) {
  flat::add_box(layout, {x_m, side * 0.95}, 0.4, 0.4, 0.0, 0.0, 0.8);
  return {"book", {x_m, side * 0.8}};
}

TraverseCorridor::Settings for_distance(double distance_m) {
  TraverseCorridor::Settings settings;
  settings.distance_m = distance_m;
  return settings;
}

double away_m(const flat::Loop& loop, Point2 place) {
  return std::hypot(loop.world.pose().x_m - place.x_m, loop.world.pose().y_m - place.y_m);
}

/// Runs on with another behaviour in the same world.
flat::RunResult then(flat::Loop& loop, Behaviour& next, double for_s) {
  next.start(loop.memory);
  return loop.run(next, loop.world.time_s() + for_s);
}

TEST(SeekLandmark, FindsABookBesideTheWallOnEitherSide) {
  for (const double side : {1.0, -1.0}) {
    flat::Layout layout = shut_corridor(14.0);
    const flat::Landmark book = stand_with_book(layout, 6.5, side);
    flat::Loop loop(layout, 21);
    loop.recognises = flat::Recogniser({book}, 21);
    SeekLandmark seek({.landmark = "book"}, loop.robot);
    const flat::RunResult result = loop.run(seek, 200.0);
    EXPECT_EQ(result.progress, Progress::succeeded) << result.why;
    EXPECT_FALSE(result.touched);
    const memory::LandmarkInMind* found = loop.memory.landmarks().find("book");
    ASSERT_NE(found, nullptr);
    EXPECT_TRUE(found->confirmed);
  }
}

TEST(SeekLandmark, TurnsBackAtTheEndAndGivesUpWithAReason) {
  flat::Loop loop(shut_corridor(5.0), 22);
  SeekLandmark seek({.landmark = "book", .turns = 1}, loop.robot);
  double farthest_m = 0.0;
  const flat::RunResult result = loop.run(
      seek, 600.0, [&](const Wish&) { farthest_m = std::max(farthest_m, loop.world.pose().x_m); });
  EXPECT_EQ(result.progress, Progress::failed);
  EXPECT_NE(result.why.find("does not find 'book'"), std::string::npos) << result.why;
  EXPECT_FALSE(result.touched);
  EXPECT_GT(farthest_m, 2.5);
  EXPECT_LT(loop.world.pose().x_m, 1.5) << "it has looked at both ends";
}

TEST(SeekLandmark, OneLookIsNotEnough) {
  flat::Loop loop(shut_corridor(14.0), 23);
  int looks = 0;
  loop.recognises = [&](flat::Loop& l) {
    if (++looks == 40) l.memory.recognise({1, "book", l.senses.now, 0.8, 0.3, 2.0});
  };
  SeekLandmark seek({.landmark = "book"}, loop.robot);
  const flat::RunResult result = loop.run(seek, 20.0);
  EXPECT_EQ(result.progress, Progress::running) << result.why;
}

TEST(ApproachLandmark, StopsBeforeItAndFacesIt) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    flat::Layout layout = shut_corridor(14.0);
    const flat::Landmark book = stand_with_book(layout, 7.0, seed % 2 == 0 ? 1.0 : -1.0);
    flat::Loop loop(layout, seed);
    loop.recognises = flat::Recogniser({book}, seed);
    SeekLandmark seek({.landmark = "book"}, loop.robot);
    ASSERT_EQ(loop.run(seek, 200.0).progress, Progress::succeeded);
    ApproachLandmark approach({.landmark = "book", .stop_at_m = 0.8}, loop.robot);
    const flat::RunResult result = then(loop, approach, 60.0);
    EXPECT_EQ(result.progress, Progress::succeeded) << "seed " << seed << " " << result.why;
    EXPECT_FALSE(result.touched) << "seed " << seed;
    EXPECT_LT(away_m(loop, book.at), 1.25) << "seed " << seed;
    EXPECT_GT(away_m(loop, book.at), 0.55) << "seed " << seed;
    const Point2 seen = inverse_transform(loop.world.pose(), book.at);
    EXPECT_LT(std::abs(std::atan2(seen.y_m, seen.x_m)), 0.25) << "seed " << seed;
  }
}

TEST(ApproachLandmark, FailsWhereTheLandmarkIsNotKnownOrNoLongerThere) {
  flat::Loop loop(shut_corridor(14.0), 31);
  ApproachLandmark unknown({.landmark = "book"}, loop.robot);
  EXPECT_EQ(loop.run(unknown, 5.0).progress, Progress::failed);
  loop.memory.recall(1, "book", {4.0, 0.0}, 0.1);  // and there is nothing
  ApproachLandmark gone({.landmark = "book"}, loop.robot);
  const flat::RunResult result = then(loop, gone, 60.0);
  EXPECT_EQ(result.progress, Progress::failed);
  EXPECT_NE(result.why.find("does not recognise"), std::string::npos) << result.why;
}

TEST(GoTo, DrivesToARecalledPlaceRoundWhatStandsInTheWay) {
  flat::Layout layout = shut_corridor(16.0);
  flat::add_box(layout, {5.0, 0.4}, 0.5, 0.9, 0.0, 0.0, 0.9);
  flat::Loop loop(layout, 41);
  for (int i = 0; i < 3; ++i) {
    TraverseCorridor ahead({}, loop.robot);
    loop.cycle(ahead, "traverse_corridor");
  }
  loop.memory.recall(1, "book", {10.0, 0.7}, 0.2);
  GoTo go({.landmark = "book", .stop_at_m = 1.0}, loop.robot);
  const flat::RunResult result = then(loop, go, 90.0);
  EXPECT_EQ(result.progress, Progress::succeeded) << result.why;
  EXPECT_FALSE(result.touched);
  EXPECT_NEAR(away_m(loop, {10.0, 0.7}), 1.0, 0.3);
}

TEST(GoTo, SaysThatItDoesNotKnowThePlace) {
  flat::Loop loop(shut_corridor(14.0), 42);
  GoTo go({.landmark = "book"}, loop.robot);
  const flat::RunResult result = loop.run(go, 5.0);
  EXPECT_EQ(result.progress, Progress::failed);
  EXPECT_NE(result.why.find("does not know where 'book' is"), std::string::npos) << result.why;
}

TEST(ReturnToStart, ComesBackThoughSomethingNewStandsInTheWay) {
  for (std::uint64_t seed = 51; seed <= 56; ++seed) {
    flat::Loop loop(shut_corridor(18.0), seed);
    TraverseCorridor ahead(for_distance(12.0), loop.robot);
    ASSERT_EQ(loop.run(ahead, 90.0).progress, Progress::succeeded);
    flat::Layout changed = loop.world.layout();
    flat::add_box(changed, {7.0, 0.35}, 0.5, 0.9, 0.0, 0.0, 0.9);
    flat::add_box(changed, {4.0, -0.6}, 0.5, 0.6, 0.0, 0.0, 0.6);
    loop.world.change(changed);
    ReturnToStart back({.facing = true}, loop.robot);
    const flat::RunResult result = then(loop, back, 120.0);
    EXPECT_EQ(result.progress, Progress::succeeded) << "seed " << seed << " " << result.why;
    EXPECT_FALSE(result.touched) << "seed " << seed;
    EXPECT_LT(away_m(loop, {0.0, 0.0}), 1.1) << "seed " << seed;
    EXPECT_LT(std::abs(wrap_angle(loop.world.pose().heading_rad)), 0.2) << "seed " << seed;
  }
}

}  // namespace
}  // namespace striate::behaviours
