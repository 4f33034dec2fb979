#include "striate/evaluation/places/eval_places.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <fstream>

#include "striate/base/files.hpp"
#include "striate/base/user_error.hpp"
#include "striate/evaluation/places/orb_words.hpp"
#include "tests/reference/rendered_room.hpp"
#include "tests/reference/test_images.hpp"

namespace striate::evaluation {
namespace {

PlaceQuestion asked(double score, bool revisit, bool right) {
  return {.image = 40, .revisit = revisit, .guess = {3, score}, .right = right};
}

TEST(EvalPlaces, WhatIsFoundWithoutAFalseOneEndsAtTheSurestMistake) {
  const std::vector<PlaceQuestion> questions = {asked(0.9, true, true),
                                                asked(0.8, true, true),
                                                asked(0.7, false, false),
                                                asked(0.6, true, true),
                                                {.image = 41, .revisit = true, .guess = {}}};
  const PlaceScore sure = without_false(questions);
  EXPECT_EQ(sure.right, 2);
  EXPECT_EQ(sure.claimed, 2);
  EXPECT_EQ(sure.revisits, 4);
  EXPECT_DOUBLE_EQ(sure.recall(), 0.5);
  EXPECT_DOUBLE_EQ(sure.threshold, 0.8);
  EXPECT_DOUBLE_EQ(at_threshold(questions, 0.65).precision(), 2.0 / 3.0);
  const std::vector<PlaceQuestion> wrong_first = {asked(0.9, true, false), asked(0.8, true, true)};
  EXPECT_EQ(without_false(wrong_first).right, 0);
  // One that is as sure as a mistake counts with it.
  const std::vector<PlaceQuestion> equal = {asked(0.9, true, true), asked(0.9, false, false)};
  EXPECT_EQ(without_false(equal).right, 0);
}

std::vector<PlacedImage> images_named(std::initializer_list<const char*> names) {
  std::vector<PlacedImage> images;
  for (const char* name : names) images.push_back({name, images.size(), {}});
  return images;
}

TEST(PlaceTruth, OfLabelsIsTheSameWithinSoMany) {
  const ScratchFolder folder;
  std::ofstream(folder / "labels.csv") << "image,place\n# by eye\na.png,1\nb.png,2.5\r\nc.png,\n";
  ASSERT_TRUE(is_place_labels(folder / "labels.csv"));
  const PlaceTruth truth = PlaceTruth::of_labels(folder / "labels.csv",
                                                 images_named({"a.png", "b.png", "c.png", "d.png"}),
                                                 {.within_places = 1.5});
  EXPECT_TRUE(truth.same(0, 1));
  EXPECT_TRUE(truth.tells_of(2));
  EXPECT_FALSE(truth.same(2, 2)) << "seen but once";
  EXPECT_FALSE(truth.tells_of(3)) << "not named";
}

TEST(PlaceTruth, OfLabelsNamesTheLineOfAMistake) {
  const ScratchFolder folder;
  for (const auto& [line, expected] : {std::pair("a.png", ":3: no name and place"),
                                       std::pair("a.png,left", ":3: \"left\" is no number"),
                                       std::pair("a.png,nan", ":3: \"nan\" is no number")}) {
    std::ofstream(folder / "labels.csv") << "image,place\nb.png,1\n" << line << "\n";
    try {
      (void)PlaceTruth::of_labels(folder / "labels.csv", images_named({"a.png", "b.png"}), {});
      ADD_FAILURE() << line;
    } catch (const UserError& error) {
      EXPECT_NE(std::string(error.what()).find(expected), std::string::npos) << error.what();
    }
  }
  std::ofstream(folder / "labels.csv") << "image,place\nelsewhere.png,1\n";
  EXPECT_THROW((void)PlaceTruth::of_labels(folder / "labels.csv", images_named({"a.png"}), {}),
               UserError);
}

TEST(PlaceTruth, OfATrajectoryAsksForPositionAndDirection) {
  datasets::Trajectory trajectory;
  trajectory.timed = false;
  for (int k = 0; k < 4; ++k) {
    trajectory.poses.push_back({.stamp_ns = k * 1'000'000'000LL, .position_m = {0.8 * k, 0, 0}});
  }
  trajectory.poses[3].position_m = {0, 0, 0};
  trajectory.poses[3].rotation = perception::rotation_about({0, 1.0, 0});
  const PlaceTruth truth = PlaceTruth::of_trajectory(trajectory, images_named({"0", "1", "2", "3"}),
                                                     {.within_m = 1.0, .within_deg = 40.0});
  EXPECT_TRUE(truth.same(0, 1));
  EXPECT_FALSE(truth.same(0, 2));
  EXPECT_FALSE(truth.same(0, 3)) << "it looks elsewhere";
  trajectory.timed = true;
  EXPECT_THROW((void)PlaceTruth::of_trajectory(trajectory, images_named({"0", "1", "2"}), {}),
               UserError);
}

TEST(OrbWords, OfTwoHeapsOfDescriptorsAreTheirMiddles) {
  std::vector<perception::Descriptor> descriptors;
  for (int k = 0; k < 40; ++k) {
    perception::Descriptor one;
    if (k >= 20) one.words.fill(~std::uint64_t{0});
    one.words[static_cast<std::size_t>(k % 4)] ^= std::uint64_t{1} << (k % 20);  // noise
    descriptors.push_back(one);
  }
  const auto words = learn_words(descriptors, 2);
  ASSERT_EQ(words.size(), 2U);
  EXPECT_EQ(words[0], perception::Descriptor{});
  for (const std::uint64_t word : words[1].words) EXPECT_EQ(std::popcount(word), 64);
  EXPECT_TRUE(learn_words({}, 5).empty());
}

TEST(OrbWords, AWordThatAllImagesHaveTellsNothing) {
  perception::Descriptor common, rare;
  rare.words.fill(~std::uint64_t{0});
  const std::vector<std::vector<perception::Descriptor>> images = {
      {common, rare}, {common}, {common, common, rare}};
  const WordBags bags(images, 2);
  EXPECT_DOUBLE_EQ(bag_likeness(bags.of(0), bags.of(2)), 1.0);
  EXPECT_DOUBLE_EQ(bag_likeness(bags.of(0), bags.of(1)), 0.0);
}

TEST(PlaceMethods, AllKnowASecondRoundThroughARoom) {
  constexpr int kRound = 6;
  for (const auto& method : place_methods(0)) {
    for (int k = 0; k < 2 * kRound; ++k) {
      const reference::RenderedRoom room;
      const double along_m = 1.5 * (k % kRound) - 3.0 + (k < kRound ? 0.0 : 0.1);
      method->see(room.see(reference::room_pose({0.0, 0.0, along_m}), {320, 240}).left);
    }
    method->learn();
    for (int k = kRound; k < 2 * kRound; ++k) {
      const PlaceGuess guess = method->ask(k, kRound);
      EXPECT_EQ(guess.image, k - kRound) << method->name();
      EXPECT_GE(guess.score, method->threshold().value_or(guess.score)) << method->name();
    }
    EXPECT_EQ(method->ask(3, 0).image, -1) << method->name();
  }
}

}  // namespace
}  // namespace striate::evaluation
