#include "striate/agent/teaching/thing_in_picture.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/imgproc.hpp>

#include "striate/agent/teaching/image_view.hpp"

namespace striate::agent {
namespace {

/// Shapes and words of many colours on one, as on a book.
cv::Mat3b painted_cover(cv::Size size, std::uint64_t seed) {
  cv::RNG random(seed);
  const auto any = [&random] {
    return cv::Scalar(random.uniform(0, 255), random.uniform(0, 255), random.uniform(0, 255));
  };
  cv::Mat3b image(size);
  image.setTo(any());
  for (int k = 0; k < 40; ++k) {
    const cv::Point at(random.uniform(0, size.width), random.uniform(0, size.height));
    const int side = random.uniform(5, size.width / 8);
    if (k % 3 == 0) cv::circle(image, at, side, any(), cv::FILLED, cv::LINE_AA);
    if (k % 3 == 1) cv::rectangle(image, cv::Rect(at.x, at.y, side, side), any(), cv::FILLED);
    if (k % 3 == 2) {
      cv::putText(image, "Striate", at, cv::FONT_HERSHEY_SIMPLEX, 0.5 + 0.02 * side, any(), 2,
                  cv::LINE_AA);
    }
  }
  return image;
}

cv::Mat3b wooden_table(cv::Size size, std::uint64_t seed) {
  cv::RNG random(seed);
  cv::Mat3b image(size);
  for (int v = 0; v < size.height; ++v) {
    for (int u = 0; u < size.width; ++u) {
      const double grain =
          0.5 + 0.5 * std::sin(0.25 * v + 3.0 * std::sin(0.01 * u) + 0.5 * std::sin(0.07 * u));
      const double noise = random.gaussian(5.0);
      image(v, u) = cv::Vec3b(cv::saturate_cast<uchar>(60.0 + 30.0 * grain + noise),
                              cv::saturate_cast<uchar>(100.0 + 50.0 * grain + noise),
                              cv::saturate_cast<uchar>(150.0 + 50.0 * grain + noise));
    }
  }
  return image;
}

cv::Mat3b spotted_cloth(cv::Size size, std::uint64_t seed) {
  cv::RNG random(seed);
  cv::Mat1f spots(size.height / 9 + 1, size.width / 9 + 1);
  random.fill(spots, cv::RNG::UNIFORM, 0.0, 1.0);
  cv::resize(spots, spots, size, 0.0, 0.0, cv::INTER_CUBIC);
  cv::Mat3b image(size);
  for (int v = 0; v < size.height; ++v) {
    for (int u = 0; u < size.width; ++u) {
      const double t = spots(v, u);
      image(v, u) = cv::Vec3b(cv::saturate_cast<uchar>(40.0 + 80.0 * t),
                              cv::saturate_cast<uchar>(60.0 + 90.0 * t),
                              cv::saturate_cast<uchar>(40.0 + 90.0 * t));
    }
  }
  return image;
}

struct Scene {
  cv::Mat3b image;
  cv::Mat1b truth;
};

Scene lay(const cv::Mat3b& table, const cv::Mat3b& thing, cv::Point at, double degrees) {
  cv::Matx23d way = cv::Mat1d(cv::getRotationMatrix2D(
      cv::Point2f(0.5F * static_cast<float>(thing.cols), 0.5F * static_cast<float>(thing.rows)),
      degrees, 1.0));
  way(0, 2) += at.x - 0.5 * thing.cols;
  way(1, 2) += at.y - 0.5 * thing.rows;
  cv::Mat3b laid;
  cv::warpAffine(thing, laid, way, table.size());
  Scene scene{table.clone(), {}};
  cv::warpAffine(cv::Mat1b(thing.size(), uchar{255}), scene.truth, way, table.size());
  laid.copyTo(scene.image, scene.truth > 128);
  return scene;
}

const cv::Size kPhoto(640, 480);

// What is cut out is the thing; where that is doubtful all is kept, as it was before.
TEST(ThingInPicture, AThingOnAPatternedTableIsCutOutWhereverItLies) {
  int cut = 0;
  int pictures = 0;
  for (const std::uint64_t seed : {1U, 2U}) {
    for (const cv::Mat3b& table : {wooden_table(kPhoto, seed), spotted_cloth(kPhoto, seed)}) {
      for (const auto& [at, degrees] : {std::pair{cv::Point(320, 240), 0.0},
                                        {cv::Point(220, 225), 13.0},
                                        {cv::Point(420, 255), 26.0},
                                        {cv::Point(100, 240), 8.0}}) {
        ++pictures;
        const Scene scene = lay(table, painted_cover({220, 280}, 50 + seed), at, degrees);
        const auto thing = find_thing(scene.image);
        if (!thing) continue;
        ++cut;
        cv::Mat1b found(kPhoto, uchar{0});
        thing->inside.copyTo(found(thing->box));
        const int both = cv::countNonZero(found & (scene.truth > 128));
        const std::string where = std::to_string(seed) + ": " + std::to_string(at.x);
        EXPECT_GT(both, 0.9 * cv::countNonZero(found)) << where;
        EXPECT_GT(both, 0.9 * cv::countNonZero(scene.truth > 128)) << where;
        EXPECT_NEAR(thing->share, cv::countNonZero(scene.truth > 128) / (640.0 * 480.0), 0.03);
      }
    }
  }
  EXPECT_GE(cut, pictures * 2 / 3) << "of " << pictures;
}

TEST(ThingInPicture, ACoverThatFillsThePictureIsKeptWhole) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    EXPECT_FALSE(find_thing(painted_cover({400, 560}, seed)).has_value()) << seed;
    cv::Mat3b framed(cv::Size(400, 560), cv::Vec3b(30, 40, 160));  // a picture on a plain cover
    painted_cover({200, 280}, seed + 20).copyTo(framed(cv::Rect(100, 90, 200, 280)));
    cv::putText(framed, "A TITLE", cv::Point(80, 470), cv::FONT_HERSHEY_SIMPLEX, 1.5,
                cv::Scalar(240, 230, 90), 3, cv::LINE_AA);
    EXPECT_FALSE(find_thing(framed).has_value()) << seed;
  }
}

TEST(ThingInPicture, NothingIsCutFromStripsAndPlainPictures) {
  EXPECT_FALSE(find_thing(cv::Mat3b(480, 640, cv::Vec3b::all(90))).has_value());
  EXPECT_FALSE(find_thing(cv::Mat3b(20, 400, cv::Vec3b::all(90))).has_value());
  EXPECT_FALSE(find_thing(wooden_table(kPhoto, 3)).has_value());
}

TEST(ThingInPicture, TheSamePictureIsCutTheSameWay) {
  const Scene scene =
      lay(wooden_table(kPhoto, 1), painted_cover({220, 280}, 51), cv::Point(320, 240), 0.0);
  const auto first = find_thing(scene.image);
  cv::theRNG().state = 99;
  const auto second = find_thing(scene.image);
  ASSERT_TRUE(first && second);
  EXPECT_EQ(first->box, second->box);
  EXPECT_EQ(cv::countNonZero(first->inside != second->inside), 0);
}

TEST(ThingInPicture, KeypointsBesideItAreNotLearned) {
  const Scene scene =
      lay(spotted_cloth(kPhoto, 2), painted_cover({220, 280}, 52), cv::Point(320, 240), 20.0);
  const memory::LongTermSettings settings;
  const auto thing = find_thing(scene.image);
  ASSERT_TRUE(thing.has_value());
  const memory::StoredView view = view_of_image(scene.image(thing->box), settings, thing->inside);
  EXPECT_LT(view.width_px, 400.0);
  ASSERT_GT(view.keypoints.size(), 50U);
  int beside = 0;
  for (const perception::ViewKeypoint& point : view.keypoints) {
    const cv::Point at = cv::Point(cvRound(point.x_px), cvRound(point.y_px)) + thing->box.tl();
    if (scene.truth(at) < 128) ++beside;
  }
  EXPECT_LT(beside, 0.1 * static_cast<double>(view.keypoints.size()));
}

}  // namespace
}  // namespace striate::agent
