#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

#include "striate/base/user_error.hpp"
#include "striate/platform/datasets/calibration/picture_rectifier.hpp"
#include "tests/unit/datasets/calibration_texts.hpp"

namespace striate::datasets {
namespace {

/// Of the wall, in the left camera's frame.
constexpr double kWallAt_m = 3.0;

/// A smooth texture without repetition, a few cm fine.
double wall_grey(double x_m, double y_m) {
  return 128.0 + 40.0 * std::sin(31.0 * x_m + 5.0 * std::sin(7.0 * y_m)) +
         40.0 * std::sin(37.0 * y_m + 6.0 * std::sin(5.0 * x_m));
}

std::vector<cv::Point2d> rays_of_all_pixels(const EyeModel& eye) {
  std::vector<cv::Point2d> pixels;
  for (int v = 0; v < eye.size_px.height; ++v) {
    for (int u = 0; u < eye.size_px.width; ++u) pixels.emplace_back(u, v);
  }
  std::vector<cv::Point2d> rays;
  if (eye.lens == Lens::equidistant) {
    cv::fisheye::undistortPoints(pixels, rays, eye.matrix, eye.distortion);
  } else {
    const cv::TermCriteria closely(cv::TermCriteria::COUNT, 60, 0.0);
    cv::undistortPoints(pixels, rays, eye.matrix, eye.distortion, cv::noArray(), cv::noArray(),
                        closely);
  }
  return rays;
}

/// What a camera sees of the wall. @param turn, way: a point X of the left camera is turn X + way
cv::Mat3b picture_of_wall(const EyeModel& eye, const cv::Matx33d& turn, const cv::Vec3d& way) {
  const std::vector<cv::Point2d> rays = rays_of_all_pixels(eye);
  const cv::Vec3d from = -(turn.t() * way);
  cv::Mat3b picture(eye.size_px);
  for (std::size_t k = 0; k < rays.size(); ++k) {
    const cv::Vec3d ray = turn.t() * cv::Vec3d(rays[k].x, rays[k].y, 1.0);
    const cv::Vec3d at = from + ray * ((kWallAt_m - from[2]) / ray[2]);
    const auto grey = cv::saturate_cast<uchar>(wall_grey(at[0], at[1]));
    picture(static_cast<int>(k)) = {grey, grey, grey};
  }
  return picture;
}

StereoModel the_model(Lens lens, std::vector<double> left, std::vector<double> right) {
  StereoModel model;
  model.left = {{320, 240}, written::kLeft, lens, std::move(left), {}};
  model.left.matrix = cv::Matx33d(229, 0, 160.5, 0, 228.5, 121, 0, 0, 1);
  model.right = {{320, 240}, written::kRight, lens, std::move(right), {}};
  model.right->matrix = cv::Matx33d(230.5, 0, 158, 0, 230, 118.5, 0, 0, 1);
  cv::Matx33d turn;
  cv::Rodrigues(cv::Vec3d(0.01, 0.02, -0.015), turn);
  model.apart = EyesApart{turn, {-0.12, 0.004, -0.003}};
  return model;
}

struct FoundShift {
  int rows = 0;
  double columns = 0.0;
};

/// Where the middle of the left picture lies in the right one.
FoundShift shift_of(const StereoFrame& frame, cv::Point at) {
  const cv::Rect patch(at.x - 20, at.y - 12, 41, 25);
  const cv::Rect around(patch.x - 40, patch.y - 3, patch.width + 40, patch.height + 6);
  cv::Mat1f score;
  cv::matchTemplate(frame.right(around), frame.left(patch), score, cv::TM_CCOEFF_NORMED);
  cv::Point best;
  cv::minMaxLoc(score, nullptr, nullptr, nullptr, &best);
  EXPECT_GT(score(best), 0.98);
  return {best.y - 3, 40.0 - best.x};
}

struct NamedLens {
  const char* name;
  Lens lens;
  std::vector<double> left;
  std::vector<double> right;
};

TEST(PictureRectifier, PutsMatchingPointsOnOneRowAtTheDisparityOfTheirDistanceForEveryLens) {
  const NamedLens lenses[] = {
      {"straight", Lens::straight, {}, {}},
      {"Brown's", Lens::radial_tangential, {-0.28, 0.07, 2e-4, -1e-4}, {-0.27, 0.06, -3e-4, 2e-4}},
      {"rational",
       Lens::radial_tangential,
       {0.2, 0.05, 0, 0, 0.01, 0.5, 0.1, 0.02},
       {0.22, 0.04, 1e-4, 0, 0.01, 0.5, 0.12, 0.02}},
      {"fisheye", Lens::equidistant, {-0.01, 0.02, -0.01, 0.002}, {-0.012, 0.018, -0.009, 0.001}}};
  for (const NamedLens& lens : lenses) {
    const StereoModel model = the_model(lens.lens, lens.left, lens.right);
    const PictureRectifier rectifier(model, {320, 240}, false);
    StereoFrame frame;
    rectifier.rectify(
        picture_of_wall(model.left, cv::Matx33d::eye(), {}),
        picture_of_wall(*model.right, model.apart->rotation, model.apart->translation_m), frame);
    EXPECT_NEAR(frame.baseline_m, cv::norm(model.apart->translation_m), 1e-12) << lens.name;
    EXPECT_GT(frame.focal_px, 100.0) << lens.name;
    for (const cv::Point at : {cv::Point(160, 120), cv::Point(100, 60), cv::Point(240, 180)}) {
      const FoundShift shift = shift_of(frame, at);
      EXPECT_EQ(shift.rows, 0) << lens.name << at;
      // The wall is a little aslant in the frame of the pair.
      EXPECT_NEAR(shift.columns, frame.focal_px * frame.baseline_m / kWallAt_m,
                  0.6 + 0.03 * shift.columns)
          << lens.name << at;
    }
  }
}

TEST(PictureRectifier, LeavesNoBlackBorder) {
  const StereoModel model =
      the_model(Lens::radial_tangential, {-0.3, 0.09, 0, 0}, {-0.3, 0.09, 0, 0});
  const PictureRectifier rectifier(model, {320, 240}, false);
  StereoFrame frame;
  const cv::Mat3b white(240, 320, cv::Vec3b(255, 255, 255));
  rectifier.rectify(white, white, frame);
  for (const cv::Mat3b& eye : {frame.left, frame.right}) {
    EXPECT_EQ(cv::norm(eye, white, cv::NORM_INF), 0.0);
  }
}

TEST(PictureRectifier, ScalesACalibrationOfTheSameShapeAndSaysSo) {
  const StereoModel model = the_model(Lens::straight, {}, {});
  const PictureRectifier same(model, {320, 240}, false);
  const PictureRectifier twice(model, {640, 480}, false);
  EXPECT_TRUE(same.remarks().empty());
  EXPECT_THAT(twice.remarks(), testing::Contains(testing::HasSubstr("scaled to 640 x 480")));
  EXPECT_NEAR(twice.focal_px(), 2.0 * same.focal_px(), 0.02 * twice.focal_px());
  EXPECT_THROW(PictureRectifier(model, {640, 360}, false), UserError);
}

TEST(PictureRectifier, LeavesRectifiedPicturesAsTheyAre) {
  StereoModel model = the_model(Lens::radial_tangential, {-0.3, 0.09, 0, 0}, {-0.3, 0.09, 0, 0});
  const PictureRectifier said(model, {320, 240}, true);
  EXPECT_FALSE(said.changes_pictures());
  model.pictures_rectified = true;
  const PictureRectifier told(model, {320, 240}, false);
  EXPECT_FALSE(told.changes_pictures());
  EXPECT_NEAR(told.doffs_px(), -2.5, 1e-12);
}

TEST(PictureRectifier, FollowsWhatTheFileSaysOfTheRectifiedPair) {
  StereoModel model = the_model(Lens::straight, {}, {});
  cv::Mat r1;
  cv::Mat r2;
  cv::Mat p1;
  cv::Mat p2;
  cv::Mat q;
  cv::stereoRectify(model.left.matrix, cv::noArray(), model.right->matrix, cv::noArray(),
                    {320, 240}, model.apart->rotation, model.apart->translation_m, r1, r2, p1, p2,
                    q, 0, 0.0);
  model.left.rectified = RectifiedEye{cv::Matx33d(r1), cv::Matx34d(p1)};
  model.right->rectified = RectifiedEye{cv::Matx33d(r2), cv::Matx34d(p2)};
  model.baseline_m = -p2.at<double>(0, 3) / p2.at<double>(0, 0);
  const PictureRectifier rectifier(model, {320, 240}, false);
  EXPECT_NEAR(rectifier.focal_px(), p1.at<double>(0, 0), 1e-9);
  EXPECT_NEAR(rectifier.doffs_px(), p2.at<double>(0, 2) - p1.at<double>(0, 2), 1e-9);
  EXPECT_NEAR(rectifier.baseline_m(), cv::norm(model.apart->translation_m), 1e-9);
}

}  // namespace
}  // namespace striate::datasets
