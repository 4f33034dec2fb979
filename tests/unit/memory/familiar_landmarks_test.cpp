#include "striate/memory/short_term/familiar_landmarks.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/reference/looks.hpp"

namespace striate::memory {
namespace {

using looks::at_ms;
using looks::blank_percept;
using looks::senses_at;

/// A landmark that was used so many seconds of operating time before 1000 s.
LandmarkModel model(std::int64_t id, const std::string& name, double used_before_s) {
  LandmarkModel model;
  model.record.id = id;
  model.record.name = name;
  model.record.history = {1, 1000.0 - used_before_s, {1000.0 - used_before_s}};
  perception::LandmarkView view;
  view.width_px = view.height_px = 20.0;
  view.descriptors.resize(1);
  view.keypoints.push_back({10.0F, 10.0F, 4.0F, 0.0F});
  model.views = {view};
  return model;
}

/// A robot that stands and looks ahead ten times a second.
class Looking {
 public:
  explicit Looking(std::vector<LandmarkModel> models)
      : landmarks_({std::move(models), {}, 1000.0}, {}) {}

  /// One cycle with an image in which these were recognised, 2 m ahead.
  const std::vector<LandmarkLesson>& cycle(
      const std::vector<int>& recognised,
      const std::vector<perception::ExpectedLook>& expected = {}) {
    ms_ += 100;
    perception::Percept percept = blank_percept(ms_);
    for (const int landmark : recognised) {
      perception::Recognition found{.landmark = landmark, .score = 0.7};
      found.bearing_rad = 0.0;
      found.distance_m = 2.0;
      found.height_m = 0.9;
      percept.recognitions.push_back(found);
    }
    percept.expected = expected;
    expected_ = landmarks_.expectations(memory_, pose_);
    const Senses senses = senses_at(ms_, pose_);
    const Recognised& look = landmarks_.recognised(percept, senses, memory_);
    sightings_ = look.sightings;
    memory_.update(senses, percept, sightings_);
    return look.lessons;
  }
  void stand_at(double x_m) { pose_.x_m = x_m; }

  perception::LandmarkExpectations expected_;
  ShortTermMemory memory_{{}, {}};
  FamiliarLandmarks landmarks_;
  std::vector<LandmarkSighting> sightings_;

 private:
  Pose2 pose_;
  int ms_ = 0;
};

TEST(FamiliarLandmarks, NamesWhatWasRecognised) {
  Looking robot({model(7, "book", 10.0), model(9, "cup", 20.0)});
  robot.cycle({1});
  ASSERT_EQ(robot.sightings_.size(), 1U);
  EXPECT_EQ(robot.sightings_[0].landmark, 9);
  EXPECT_EQ(robot.sightings_[0].name, "cup");
  ASSERT_NE(robot.memory_.landmarks().find("cup"), nullptr);
  EXPECT_NEAR(robot.memory_.landmarks().find("cup")->place.x_m, 2.0, 1e-9);
}

TEST(FamiliarLandmarks, ASightingTeachesOnceItIsConfirmedAndAgainFromAnotherPlace) {
  Looking robot({model(7, "book", 10.0)});
  EXPECT_TRUE(robot.cycle({0}).empty());
  EXPECT_TRUE(robot.cycle({0}).empty());
  ASSERT_EQ(robot.cycle({0}).size(), 1U);
  EXPECT_TRUE(robot.cycle({0}).empty()) << "the same place";
  robot.stand_at(0.6);
  const auto& lessons = robot.cycle({0});
  ASSERT_EQ(lessons.size(), 1U);
  EXPECT_EQ(lessons[0].kind, LandmarkLesson::Kind::recognised);
  EXPECT_EQ(lessons[0].name, "book");
}

TEST(FamiliarLandmarks, ThreeMissesInARowAreALessonHiddenOnesAreNone) {
  Looking robot({model(7, "book", 10.0)});
  const std::vector<perception::ExpectedLook> missed = {{0, perception::LookResult::missed}};
  for (int k = 0; k < 9; ++k)
    EXPECT_TRUE(robot.cycle({}, {{0, perception::LookResult::hidden}}).empty());
  EXPECT_TRUE(robot.cycle({}, missed).empty());
  EXPECT_TRUE(robot.cycle({}, missed).empty());
  const auto& lessons = robot.cycle({}, missed);
  ASSERT_EQ(lessons.size(), 1U);
  EXPECT_EQ(lessons[0].kind, LandmarkLesson::Kind::missed);
}

TEST(FamiliarLandmarks, OneSightingBreaksARowOfMisses) {
  Looking robot({model(7, "book", 10.0)});
  const std::vector<perception::ExpectedLook> missed = {{0, perception::LookResult::missed}};
  robot.cycle({}, missed);
  robot.cycle({}, missed);
  robot.cycle({0}, {{0, perception::LookResult::found}});
  EXPECT_TRUE(robot.cycle({}, missed).empty());
}

TEST(FamiliarLandmarks, ViewsAreLookedForMostActiveFirstByTheirPlaceInTheListOfAllViews) {
  LandmarkModel two_sides = model(9, "cup", 20.0);
  two_sides.views.push_back(two_sides.views.front());
  const std::vector<LandmarkModel> models = {model(7, "book", 30.0), two_sides};
  const std::vector<perception::KnownView> views = views_of({models, {}, 1000.0});
  ASSERT_EQ(views.size(), 3U);
  EXPECT_EQ(views[0].landmark, 0);
  EXPECT_EQ(views[2].landmark, 1);
  Looking robot(models);
  robot.cycle({});
  EXPECT_THAT(robot.expected_.views, testing::ElementsAre(1, 2, 0));
  EXPECT_TRUE(robot.expected_.places.empty());
}

TEST(FamiliarLandmarks, WhatTheTaskSeeksComesFirst) {
  const std::vector<LandmarkModel> models = {model(7, "book", 30.0), model(9, "cup", 20.0)};
  ShortTermMemory memory({}, {});
  FamiliarLandmarks landmarks({models, {}, 1000.0}, {}, "book");
  EXPECT_THAT(landmarks.expectations(memory, {}).views, testing::ElementsAre(0, 1));
}

TEST(FamiliarLandmarks, WhatWasRecognisedIsExpectedWhereItWas) {
  Looking robot({model(7, "book", 10.0)});
  robot.cycle({0});
  robot.cycle({});
  ASSERT_EQ(robot.expected_.places.size(), 1U);
  EXPECT_EQ(robot.expected_.places[0].landmark, 0);
  EXPECT_NEAR(robot.expected_.places[0].place.x_m, 2.0, 1e-9);
  EXPECT_NEAR(robot.expected_.places[0].place.z_m, 0.9, 1e-9);
}

TEST(FamiliarLandmarks, KnowsNothingAndCostsNothingByDefault) {
  FamiliarLandmarks none;
  ShortTermMemory memory({}, {});
  EXPECT_TRUE(none.expectations(memory, {}).views.empty());
  EXPECT_TRUE(views_of({}).empty());
  const Recognised& recognised = none.recognised(blank_percept(100), senses_at(100, {}), memory);
  EXPECT_TRUE(recognised.sightings.empty());
  EXPECT_TRUE(recognised.lessons.empty());
}

}  // namespace
}  // namespace striate::memory
