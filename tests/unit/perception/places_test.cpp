#include <gtest/gtest.h>

#include <numbers>

#include "striate/perception/places/place_recogniser.hpp"
#include "tests/reference/every_target.hpp"
#include "tests/reference/rendered_room.hpp"

namespace striate::perception {
namespace {

/// A room of 18 m, seen every 1.5 m along it.
cv::Mat1b look_along(double along_m, double aside_m, double turn_rad, double light = 1.0,
                     double noise = 0.0, int seed = 1) {
  reference::RenderedRoom room;
  room.light = light;
  room.noise = noise;
  return room
      .see(reference::room_pose({aside_m, 0.0, along_m}, {0.0, turn_rad, 0.0}), {320, 240}, seed)
      .left;
}

constexpr int kRoomPlaces = 6;

class Places : public testing::Test {
 protected:
  void remember_room() {
    for (int k = 0; k < kRoomPlaces; ++k) places_.add(eye_.look(look_along(1.5 * k - 3.0, 0, 0)));
  }
  PlaceEye eye_;
  PlaceRecogniser places_;
};

TEST_F(Places, AreKnownAgainInOtherLightAndFromAStepAside) {
  remember_room();
  for (int k = 0; k < kRoomPlaces; ++k) {
    const PlaceAnswer answer =
        places_.find(eye_.look(look_along(1.5 * k - 2.8, 0.15, 0.05, 0.7, 3.0, k + 2)));
    EXPECT_EQ(answer.verdict, PlaceVerdict::known) << k << ": " << word_of(answer.verdict);
    EXPECT_EQ(answer.matches.front().place, k);
    EXPECT_GE(answer.confidence, 0.5);
    EXPECT_GT(answer.matches.front().scale, 1.0) << "it was seen from farther away";
  }
}

TEST_F(Places, OneThatWasNeverSeenIsNotKnown) {
  remember_room();
  for (int k = 0; k < kRoomPlaces; ++k) {
    const PlaceAnswer answer =
        places_.find(eye_.look(look_along(1.5 * k - 3.0, 0.0, std::numbers::pi)));
    EXPECT_EQ(answer.verdict, PlaceVerdict::nothing_agrees) << k;
    EXPECT_LT(answer.confidence, 0.4) << k;
  }
}

TEST_F(Places, TheGistAloneConfirmsNothing) {
  PlaceView view = eye_.look(look_along(0.0, 0.0, 0.0));
  const PlaceView now = view;
  view.view.keypoints.clear();
  view.view.descriptors.clear();
  places_.add(view);
  const PlaceAnswer answer = places_.find(now);
  EXPECT_EQ(answer.verdict, PlaceVerdict::nothing_agrees);
  EXPECT_EQ(answer.matches.front().gist_distance, 0.0);
  EXPECT_EQ(answer.matches.front().evidence, 0.0);
}

TEST_F(Places, TwoThatLookTheSameAreAmbiguousUnlessTheyAreNeighbours) {
  remember_room();
  places_.add(eye_.look(look_along(1.5 * 2 - 3.0, 0.0, 0.0, 1.0, 2.0)));
  const PlaceView now = eye_.look(look_along(1.5 * 2 - 3.0, 0.05, 0.0));
  const PlaceAnswer apart = places_.find(now);
  EXPECT_EQ(apart.verdict, PlaceVerdict::ambiguous);
  EXPECT_LT(apart.confidence, 0.5);
  ASSERT_GE(apart.other, 1);
  const PlaceAnswer together =
      places_.find(now, {}, [](int a, int b) { return a % 4 == 2 && b % 4 == 2; });
  EXPECT_EQ(together.verdict, PlaceVerdict::known);
}

TEST_F(Places, TheNeighboursOfTheBestProposalAreComparedToo) {
  PlaceSettings one_proposal;
  one_proposal.proposals = 1;
  PlaceRecogniser places(one_proposal);
  PlaceView right = eye_.look(look_along(0.05, 0.0, 0.0));
  right.gist = eye_.look(look_along(6.0, 0.0, 0.0)).gist;  // it is not proposed
  places.add(right);
  places.add(eye_.look(look_along(-0.6, 0.0, 0.0)));
  const PlaceView now = eye_.look(look_along(0.0, 0.0, 0.0));
  EXPECT_EQ(places.find(now).matches.front().place, 1);
  const PlaceAnswer answer = places.find(now, {}, [](int, int) { return true; });
  ASSERT_EQ(answer.matches.size(), 2U);
  EXPECT_EQ(answer.matches.front().place, 0);
  const auto only_one = [](int place) { return place == 1; };
  EXPECT_EQ(places.find(now, only_one, [](int, int) { return true; }).matches.size(), 1U);
}

TEST_F(Places, OnlyThoseThatMayBeAreLookedAt) {
  const PlaceView now = eye_.look(look_along(0.0, 0.0, 0.0));
  EXPECT_EQ(places_.find(now).verdict, PlaceVerdict::nothing_known);
  remember_room();
  const PlaceAnswer answer = places_.find(now, [](int place) { return place >= 4; });
  EXPECT_EQ(answer.matches.size(), 2U);
  for (const PlaceMatch& match : answer.matches) EXPECT_GE(match.place, 4);
  EXPECT_EQ(places_.find(now, [](int) { return false; }).verdict, PlaceVerdict::nothing_known);
}

TEST_F(Places, TheAnswerIsTheSameOnEveryInstructionSet) {
  remember_room();
  const cv::Mat1b now = look_along(0.2, 0.1, 0.03, 0.8, 2.0);
  const PlaceAnswer plain = places_.find(eye_.look(now));
  reference::on_every_target([&](const std::string& name) {
    const PlaceAnswer answer = places_.find(eye_.look(now));
    EXPECT_EQ(answer.confidence, plain.confidence) << name;
    ASSERT_EQ(answer.matches.size(), plain.matches.size()) << name;
    for (std::size_t k = 0; k < plain.matches.size(); ++k) {
      EXPECT_EQ(answer.matches[k].place, plain.matches[k].place) << name;
      EXPECT_EQ(answer.matches[k].evidence, plain.matches[k].evidence) << name;
    }
  });
}

TEST_F(Places, AViewWithoutADescriptorForEachKeypointIsRefused) {
  PlaceView view;
  view.view.keypoints.resize(1);
  EXPECT_THROW(places_.add(view), std::invalid_argument);
}

}  // namespace
}  // namespace striate::perception
