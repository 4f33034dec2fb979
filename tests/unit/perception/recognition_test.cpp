#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <cstdlib>
#include <new>
#include <numbers>
#include <opencv2/imgproc.hpp>

#include "striate/base/user_error.hpp"
#include "striate/perception/recognition/oriented_keypoints.hpp"
#include "striate/perception/recognition/recogniser.hpp"
#include "tests/reference/every_target.hpp"
#include "tests/reference/hamming_reference.hpp"
#include "tests/reference/test_images.hpp"

// Counts, for RecognisesWithoutAllocatingOnceItHasSeenAnImage. Sanitizers have an allocator of
// their own, which this must not take apart.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define STRIATE_COUNTS_ALLOCATIONS 0
#else
#define STRIATE_COUNTS_ALLOCATIONS 1
namespace {
std::atomic<long> allocations{0};
}

void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept {
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}
#endif

namespace striate::perception {
namespace {

using reference::disturbed;

std::vector<Keypoint> keypoints_of(const cv::Mat1b& grey) {
  return OrientedKeypoints(OrientedSettings{})(grey);
}

/// An object with texture of coarse grains, so that it bears being made smaller.
cv::Mat1b object_image(int seed) {
  cv::Mat1b fine = reference::texture({80, 60}, seed), coarse;
  cv::resize(fine, coarse, {240, 180}, 0, 0, cv::INTER_CUBIC);
  return coarse;
}

/// Knows the objects of these seeds; landmark k is the k-th.
Recogniser taught(std::initializer_list<int> seeds, const RecognitionSettings& settings = {}) {
  Recogniser recogniser(settings);
  int landmark = 0;
  for (const int seed : seeds) {
    recogniser.add(landmark++, make_view(object_image(seed), {0, 0, 240, 180}, keypoints_of));
  }
  return recogniser;
}

/// Another texture with the object in it, turned and scaled about (320, 240).
cv::Mat1b scene_with(int seed, double angle_deg, double scale) {
  cv::Mat1b fine = reference::texture({213, 160}, 900), scene;
  cv::resize(fine, scene, {640, 480}, 0, 0, cv::INTER_CUBIC);
  cv::Mat1d turn = cv::getRotationMatrix2D({119.5F, 89.5F}, angle_deg, scale);
  turn(0, 2) += 320 - 119.5;
  turn(1, 2) += 240 - 89.5;
  const cv::Mat1b object = object_image(seed);
  cv::warpAffine(object, scene, turn, scene.size(), cv::INTER_AREA, cv::BORDER_TRANSPARENT);
  return scene;
}

TEST(Recogniser, FindsAnObjectThatIsTurnedAndScaledAndSaysWhereItIs) {
  Recogniser recogniser = taught({11, 12});
  for (const auto& [angle_deg, scale] :
       {std::pair{0.0, 1.0}, {25.0, 0.8}, {140.0, 1.2}, {-75.0, 0.7}, {180.0, 1.6}}) {
    const auto& found = recogniser.recognise(keypoints_of(scene_with(12, angle_deg, scale)));
    ASSERT_EQ(found.size(), 1U) << angle_deg << " deg, scale " << scale;
    EXPECT_EQ(found[0].landmark, 1);
    EXPECT_NEAR(found[0].u_px, 320, 4);
    EXPECT_NEAR(found[0].v_px, 240, 4);
    EXPECT_NEAR(found[0].scale, scale, 0.05 * scale);
    // OpenCV turns counter-clockwise as it is seen, v points down.
    const double angle_rad = -angle_deg * std::numbers::pi / 180.0;
    EXPECT_NEAR(std::remainder(found[0].angle_rad - angle_rad, 2.0 * std::numbers::pi), 0.0, 0.06);
    EXPECT_GE(found[0].score, 0.5);
  }
}

TEST(Recogniser, FindsAnObjectInOtherLight) {
  Recogniser recogniser = taught({11, 12});
  cv::Mat1b scene = scene_with(11, 40.0, 0.9);
  scene.convertTo(scene, CV_8U, 0.5, 20.0);
  const auto& found = recogniser.recognise(keypoints_of(reference::with_noise(scene, 4.0, 3)));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].landmark, 0);
}

TEST(Recogniser, FindsAnObjectThatIsPartlyHidden) {
  cv::Mat1b scene = scene_with(11, 20.0, 1.0);
  scene(cv::Rect(320, 0, 320, 480)).setTo(90);
  Recogniser recogniser = taught({11, 12});
  const auto& found = recogniser.recognise(keypoints_of(scene));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].landmark, 0);
}

TEST(Recogniser, AnObjectThatIsNotThereGivesNothing) {
  Recogniser recogniser = taught({11, 12, 14, 15, 16, 17, 18, 19});
  for (const int seed : {13, 21, 22}) {
    EXPECT_TRUE(recogniser.recognise(keypoints_of(scene_with(seed, 20.0, 1.0))).empty()) << seed;
  }
  EXPECT_TRUE(recogniser.recognise({}).empty());
  EXPECT_TRUE(taught({}).recognise(keypoints_of(scene_with(11, 0.0, 1.0))).empty());
}

TEST(Recogniser, LooksAtTheMostActiveViewsUntilTheBudgetIsSpent) {
  Recogniser recogniser = taught({11, 12});
  const std::vector<Keypoint> seen = keypoints_of(scene_with(12, 25.0, 0.9));
  const std::vector<int> wrong_first = {0, 1}, right_first = {1, 0};
  RecognitionBudget one;
  one.most_views = 1;
  EXPECT_TRUE(recogniser.recognise(seen, wrong_first, one).empty());
  EXPECT_EQ(recogniser.recognise(seen, right_first, one).size(), 1U);
  EXPECT_EQ(recogniser.looked_at(), 1U);
  EXPECT_EQ(recogniser.recognise(seen, wrong_first, {}).size(), 1U);
  EXPECT_EQ(recogniser.looked_at(), 2U);
  RecognitionBudget none_left;
  none_left.goes_on = [] { return false; };
  EXPECT_EQ(recogniser.recognise(seen, right_first, none_left).size(), 1U) << "the first is free";
  EXPECT_TRUE(recogniser.recognise(seen, wrong_first, none_left).empty());
}

TEST(Recogniser, ForgetsAViewThatIsRemovedAndGivesItsNumberAgain) {
  Recogniser recogniser = taught({11, 12});
  const std::vector<Keypoint> seen = keypoints_of(scene_with(12, 25.0, 0.9));
  recogniser.remove(1);
  EXPECT_EQ(recogniser.size(), 1U);
  EXPECT_TRUE(recogniser.recognise(seen).empty());
  EXPECT_TRUE(recogniser.recognise(seen, std::vector<int>{1, 0}, {}).empty());
  EXPECT_EQ(recogniser.add(7, make_view(object_image(12), {0, 0, 240, 180}, keypoints_of)), 1);
  ASSERT_EQ(recogniser.recognise(seen).size(), 1U);
  EXPECT_EQ(recogniser.recognise(seen)[0].landmark, 7);
  EXPECT_THROW(recogniser.remove(5), std::out_of_range);
  recogniser.remove(1);
  EXPECT_THROW(recogniser.remove(1), std::out_of_range);
}

TEST(Recogniser, RefusesViewsThatDoNotFitTogether) {
  Recogniser recogniser({});
  LandmarkView view{std::vector<Descriptor>(2), std::vector<ViewKeypoint>(1), 10.0, 10.0};
  EXPECT_THROW(recogniser.add(0, view), std::invalid_argument);
  EXPECT_THROW(recogniser.add(0, LandmarkView{}), std::invalid_argument);
  EXPECT_EQ(recogniser.size(), 0U);
}

TEST(Recogniser, EveryInstructionSetRecognisesTheSame) {
  const cv::Mat1b scene = scene_with(11, 25.0, 0.8)(cv::Rect(200, 140, 240, 200)).clone();
  std::vector<Recognition> first;
  reference::on_every_target([&](const std::string& name) {
    Recogniser recogniser = taught({11});
    const auto& found = recogniser.recognise(keypoints_of(scene));
    ASSERT_EQ(found.size(), 1U) << name;
    if (first.empty()) first = found;
    EXPECT_EQ(found[0].inliers, first[0].inliers) << name;
    EXPECT_EQ(found[0].u_px, first[0].u_px) << name;
    EXPECT_EQ(found[0].scale, first[0].scale) << name;
  });
}

/// A view of `count` keypoints, and an image that shows so many of them at a distance in bits.
std::vector<Recognition> by_papers_rule(std::size_t count, std::size_t shown, int bits) {
  LandmarkView view{{}, {}, 100.0, 100.0};
  std::vector<Keypoint> seen;
  const std::vector<Descriptor> descriptors = reference::random_descriptors(count, 4);
  for (std::size_t k = 0; k < count; ++k) {
    Keypoint point;
    point.descriptor = descriptors[k];
    view.descriptors.push_back(point.descriptor);
    view.keypoints.push_back({0.0F, 0.0F, 1.0F, 0.0F});
    if (k >= shown) continue;
    point.descriptor = disturbed(point.descriptor, bits, static_cast<unsigned>(k) * 999U);
    seen.push_back(point);
  }
  RecognitionSettings settings;
  settings.mode = RecognitionMode::paper;
  Recogniser recogniser(settings);
  recogniser.add(0, view);
  return recogniser.recognise(seen);
}

TEST(Recogniser, ThePapersRuleConfirmsAtHalfOfTheDescriptorsBelow48Bits) {
  EXPECT_EQ(by_papers_rule(20, 10, 47).size(), 1U);
  EXPECT_TRUE(by_papers_rule(20, 9, 47).empty()) << "less than half";
  EXPECT_TRUE(by_papers_rule(20, 20, 48).empty()) << "not below 48";
  EXPECT_TRUE(by_papers_rule(21, 10, 0).empty()) << "less than half of an odd number";
  EXPECT_DOUBLE_EQ(by_papers_rule(20, 15, 47).at(0).matched_fraction, 0.75);
}

#if STRIATE_COUNTS_ALLOCATIONS
TEST(Recogniser, RecognisesWithoutAllocatingOnceItHasSeenAnImage) {
  const std::vector<Keypoint> seen = keypoints_of(scene_with(11, 25.0, 0.8));
  for (const RecognitionMode mode : {RecognitionMode::paper, RecognitionMode::robust}) {
    RecognitionSettings settings;
    settings.mode = mode;
    settings.paper_share = 0.0;
    Recogniser recogniser = taught({11, 12}, settings);
    EXPECT_FALSE(recogniser.recognise(seen).empty());
    const long before = allocations;
    EXPECT_FALSE(recogniser.recognise(seen).empty());
    EXPECT_EQ(allocations, before);
  }
}
#endif

TEST(Recogniser, RefusesSettingsOutOfRange) {
  RecognitionSettings settings;
  settings.limit_bits = 0;
  EXPECT_THROW(Recogniser{settings}, UserError);
  settings = {};
  settings.least_inliers = 2;
  EXPECT_THROW(Recogniser{settings}, UserError);
}

TEST(Recogniser, MayAskForAnUprightViewAndForAShareOfWhatCanBeSeen) {
  RecognitionSettings upright;
  upright.most_turn_rad = 0.8;
  Recogniser recogniser = taught({11}, upright);
  EXPECT_EQ(recogniser.recognise(keypoints_of(scene_with(11, 20.0, 0.7))).size(), 1U);
  EXPECT_TRUE(recogniser.recognise(keypoints_of(scene_with(11, 140.0, 0.7))).empty());
  cv::Mat1b scene = scene_with(11, 0.0, 1.0);
  RecognitionSettings share;
  share.least_share = 0.12;
  EXPECT_EQ(taught({11}, share).recognise(keypoints_of(scene)).size(), 1U);
  EXPECT_EQ(taught({11}, share).recognise(keypoints_of(scene_with(11, 0.0, 0.5))).size(), 1U);
  share.least_share = 0.95;
  scene(cv::Rect(320, 0, 320, 480)).setTo(90);  // half of it is hidden
  EXPECT_TRUE(taught({11}, share).recognise(keypoints_of(scene)).empty());
}

TEST(LandmarkView, HoldsTheKeypointsOfItsRegionOnly) {
  const cv::Mat1b image = scene_with(11, 0.0, 1.0);
  const cv::Rect region(200, 150, 240, 180);
  const LandmarkView view = make_view(image, region, keypoints_of);
  EXPECT_EQ(view.width_px, 240.0);
  ASSERT_GT(view.keypoints.size(), 20U);
  EXPECT_EQ(view.keypoints.size(), view.descriptors.size());
  for (const ViewKeypoint& point : view.keypoints) {
    EXPECT_TRUE(point.x_px > -1 && point.x_px < 240 && point.y_px > -1 && point.y_px < 180);
  }
  EXPECT_THROW((void)make_view(image, {700, 0, 10, 10}, keypoints_of), UserError);
}

TEST(Pose, LeastSquaresGivesBackThePoseThatMadeThePairs) {
  const Pose truth{0.9, -0.3, 40.0, 0.2, 1.1, -7.0};
  std::vector<PlacePair> pairs;
  for (const auto& [u, v] : {std::pair{0.0, 0.0}, {90.0, 10.0}, {30.0, 70.0}, {80.0, 80.0}}) {
    pairs.push_back({{u, v}, {truth.u_of(u, v), truth.v_of(u, v)}});
  }
  const Pose pose = fit_affine(pairs);
  EXPECT_NEAR(pose.a, truth.a, 1e-9);
  EXPECT_NEAR(pose.b, truth.b, 1e-9);
  EXPECT_NEAR(pose.d, truth.d, 1e-9);
  EXPECT_NEAR(pose.f, truth.f, 1e-9);
  const Pose turned{0.6, -0.8, 5.0, 0.8, 0.6, 1.0};
  for (PlacePair& pair : pairs) {
    pair.image.u_px = turned.u_of(pair.view.u_px, pair.view.v_px);
    pair.image.v_px = turned.v_of(pair.view.u_px, pair.view.v_px);
  }
  EXPECT_NEAR(fit_similarity(pairs).d, 0.8, 1e-9);
  EXPECT_NEAR(turned.stretch(), 1.0, 1e-9);
}

}  // namespace
}  // namespace striate::perception
