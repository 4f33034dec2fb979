#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <cstdlib>
#include <new>
#include <opencv2/imgproc.hpp>

#include "config/user_error.hpp"
#include "perception/recognition/pyramid_keypoints.hpp"
#include "perception/recognition/recogniser.hpp"
#include "tests/reference/every_target.hpp"
#include "tests/reference/hamming_reference.hpp"
#include "tests/reference/test_pictures.hpp"

// Counts, for RecognisesWithoutAllocatingOnceItHasSeenAPicture. Sanitizers have an allocator of
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
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}
#endif

namespace striate {
namespace {

using reference::disturbed;

std::vector<Keypoint> keypoints_of(const cv::Mat1b& grey) {
  return PyramidKeypoints(PyramidSettings{})(grey);
}

/// An object with texture of coarse grains, so that it bears being made smaller.
cv::Mat1b object_picture(int seed) {
  cv::Mat1b fine = reference::texture({80, 60}, seed), coarse;
  cv::resize(fine, coarse, {240, 180}, 0, 0, cv::INTER_CUBIC);
  return coarse;
}

ObjectModel model_of(const std::string& name, int seed) {
  const cv::Mat1b picture = object_picture(seed);
  return {name, make_turned_views(picture, {0, 0, 240, 180}, 12, keypoints_of)};
}

/// Another texture with the object in it, turned and scaled about (320, 240).
cv::Mat1b scene_with(int seed, double angle_deg, double scale) {
  cv::Mat1b fine = reference::texture({213, 160}, 900), scene;
  cv::resize(fine, scene, {640, 480}, 0, 0, cv::INTER_CUBIC);
  cv::Mat1d turn = cv::getRotationMatrix2D({119.5F, 89.5F}, angle_deg, scale);
  turn(0, 2) += 320 - 119.5;
  turn(1, 2) += 240 - 89.5;
  const cv::Mat1b object = object_picture(seed);
  cv::warpAffine(object, scene, turn, scene.size(), cv::INTER_AREA, cv::BORDER_TRANSPARENT);
  return scene;
}

TEST(Recogniser, FindsAnObjectThatIsTurnedAndScaledAndSaysWhereItIs) {
  const std::vector<ObjectModel> models = {model_of("one", 11), model_of("two", 12)};
  Recogniser recogniser(models, {});
  for (const auto& [angle_deg, scale] :
       {std::pair{0.0, 1.0}, {25.0, 0.8}, {140.0, 1.2}, {-75.0, 0.7}}) {
    const auto& found = recogniser.recognise(keypoints_of(scene_with(12, angle_deg, scale)));
    ASSERT_EQ(found.size(), 1U) << angle_deg << " deg, scale " << scale;
    EXPECT_EQ(found[0].object, 1);
    EXPECT_NEAR(found[0].u_px, 320, 12);
    EXPECT_NEAR(found[0].v_px, 240, 12);
    EXPECT_NEAR(found[0].scale, scale, 0.1 * scale);
  }
}

TEST(Recogniser, FindsAnObjectThatIsPartlyHidden) {
  const std::vector<ObjectModel> models = {model_of("one", 11), model_of("two", 12)};
  cv::Mat1b scene = scene_with(11, 20.0, 1.0);
  scene(cv::Rect(320, 0, 320, 480)).setTo(90);
  Recogniser recogniser(models, {});
  const auto& found = recogniser.recognise(keypoints_of(scene));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].object, 0);
}

TEST(Recogniser, AnObjectThatIsNotThereGivesNothing) {
  const std::vector<ObjectModel> models = {model_of("one", 11), model_of("two", 12)};
  Recogniser recogniser(models, {});
  EXPECT_TRUE(recogniser.recognise(keypoints_of(scene_with(13, 20.0, 1.0))).empty());
  EXPECT_TRUE(recogniser.recognise({}).empty());
  EXPECT_TRUE(Recogniser({}, {}).recognise(keypoints_of(scene_with(11, 0.0, 1.0))).empty());
}

TEST(Recogniser, EveryInstructionSetRecognisesTheSame) {
  const std::vector<ObjectModel> models = {model_of("one", 11)};
  const std::vector<Keypoint> seen = keypoints_of(scene_with(11, 25.0, 0.8));
  std::vector<Recognition> first;
  reference::on_every_target([&](const std::string& name) {
    Recogniser recogniser(models, {});
    const auto& found = recogniser.recognise(seen);
    ASSERT_EQ(found.size(), 1U) << name;
    if (first.empty()) first = found;
    EXPECT_EQ(found[0].inliers, first[0].inliers) << name;
    EXPECT_EQ(found[0].u_px, first[0].u_px) << name;
    EXPECT_EQ(found[0].scale, first[0].scale) << name;
  });
}

/// A view of `count` keypoints, and a picture that shows so many of them at a distance in bits.
std::vector<Recognition> by_papers_rule(std::size_t count, std::size_t shown, int bits) {
  ObjectModel model{"object", {ObjectView{{}, 100.0, 100.0}}};
  std::vector<Keypoint> seen;
  const std::vector<Descriptor> descriptors = reference::random_descriptors(count, 4);
  for (std::size_t k = 0; k < count; ++k) {
    Keypoint point;
    point.descriptor = descriptors[k];
    model.views[0].keypoints.push_back(point);
    if (k >= shown) continue;
    point.descriptor = disturbed(point.descriptor, bits, static_cast<unsigned>(k) * 999U);
    seen.push_back(point);
  }
  RecognitionSettings settings;
  settings.setting = RecognitionSetting::paper;
  return Recogniser({&model, 1}, settings).recognise(seen);
}

TEST(Recogniser, ThePapersRuleConfirmsAtHalfOfTheDescriptorsBelow48Bits) {
  EXPECT_EQ(by_papers_rule(20, 10, 47).size(), 1U);
  EXPECT_TRUE(by_papers_rule(20, 9, 47).empty()) << "less than half";
  EXPECT_TRUE(by_papers_rule(20, 20, 48).empty()) << "not below 48";
  EXPECT_TRUE(by_papers_rule(21, 10, 0).empty()) << "less than half of an odd number";
  EXPECT_DOUBLE_EQ(by_papers_rule(20, 15, 47).at(0).matched_fraction, 0.75);
}

#if STRIATE_COUNTS_ALLOCATIONS
TEST(Recogniser, RecognisesWithoutAllocatingOnceItHasSeenAPicture) {
  const std::vector<ObjectModel> models = {model_of("one", 11), model_of("two", 12)};
  const std::vector<Keypoint> seen = keypoints_of(scene_with(11, 25.0, 0.8));
  for (const RecognitionSetting setting : {RecognitionSetting::paper, RecognitionSetting::robust}) {
    RecognitionSettings settings;
    settings.setting = setting;
    settings.paper_share = 0.0;
    Recogniser recogniser(models, settings);
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
  EXPECT_THROW(Recogniser({}, settings), UserError);
  settings = {};
  settings.least_inliers = 2;
  EXPECT_THROW(Recogniser({}, settings), UserError);
}

TEST(ObjectView, HoldsTheKeypointsOfItsRegionOnly) {
  const cv::Mat1b picture = scene_with(11, 0.0, 1.0);
  const cv::Rect region(200, 150, 240, 180);
  const ObjectView view = make_view(picture, region, keypoints_of);
  EXPECT_EQ(view.width_px, 240.0);
  ASSERT_GT(view.keypoints.size(), 20U);
  for (const Keypoint& point : view.keypoints) {
    EXPECT_TRUE(point.u_px > -1 && point.u_px < 240 && point.v_px > -1 && point.v_px < 180);
  }
  EXPECT_THROW((void)make_view(picture, {700, 0, 10, 10}, keypoints_of), UserError);
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
    pair.picture.u_px = turned.u_of(pair.view.u_px, pair.view.v_px);
    pair.picture.v_px = turned.v_of(pair.view.u_px, pair.view.v_px);
  }
  EXPECT_NEAR(fit_similarity(pairs).d, 0.8, 1e-9);
  EXPECT_NEAR(turned.stretch(), 1.0, 1e-9);
}

}  // namespace
}  // namespace striate
