#include "striate/platform/datasets/calibration/picture_rectifier.hpp"

#include <fmt/format.h>

#include <cmath>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

#include "striate/base/user_error.hpp"
#include "striate/platform/datasets/calibration/common_pinhole.hpp"
#include "striate/platform/datasets/calibration/lens_rays.hpp"

namespace striate::datasets {
namespace {

/// Of width over height: scaled pictures are rounded to whole pixels.
constexpr double kSameShape = 0.01;

void scale_eye(EyeModel& eye, double by) {
  // Pixel centres are at integers.
  const auto scale = [by](auto& matrix) {
    matrix(0, 0) *= by;
    matrix(1, 1) *= by;
    matrix(0, 2) = (matrix(0, 2) + 0.5) * by - 0.5;
    matrix(1, 2) = (matrix(1, 2) + 0.5) * by - 0.5;
  };
  scale(eye.matrix);
  if (!eye.rectified) return;
  scale(eye.rectified->projection);
  eye.rectified->projection(0, 3) *= by;
  eye.rectified->projection(1, 3) *= by;
}

/// Where the file tells no size, a principal point in the middle third says that it is this one.
void check_middle(const EyeModel& eye, cv::Size size) {
  const double u = eye.matrix(0, 2) / size.width;
  const double v = eye.matrix(1, 2) / size.height;
  constexpr double kEdge = 0.25;  // share of the picture: no lens is mounted so far aside (ours)
  if (u > kEdge && u < 1.0 - kEdge && v > kEdge && v < 1.0 - kEdge) return;
  throw UserError(fmt::format(
      "the pictures are {} x {} px, and the calibration's principal point ({:.1f}, {:.1f}) is not "
      "in their middle\n    hint: it is of pictures of another size: say in it which "
      "(image_width, image_height)",
      size.width, size.height, eye.matrix(0, 2), eye.matrix(1, 2)));
}

void fit_to(StereoModel& model, cv::Size size, std::vector<std::string>& remarks) {
  const cv::Size told =
      !model.left.size_px.empty() || !model.right ? model.left.size_px : model.right->size_px;
  if (told.empty()) {
    check_middle(model.left, size);
    remarks.emplace_back("the calibration tells no size: taken for that of the pictures");
  } else if (told != size) {
    const double by = static_cast<double>(size.width) / told.width;
    const double shape = by * told.height / size.height;
    if (std::abs(shape - 1.0) > kSameShape) {
      throw UserError(fmt::format(
          "the pictures are {} x {} px, the calibration is for {} x {}: another shape\n    hint: "
          "pictures that were cut, or are of another camera, need a calibration of their own; "
          "both eyes side by side in one picture: --side-by-side",
          size.width, size.height, told.width, told.height));
    }
    scale_eye(model.left, by);
    if (model.right) scale_eye(*model.right, by);
    model.doffs_px *= by;
    remarks.push_back(fmt::format("the calibration is for {} x {} px: scaled to {} x {}",
                                  told.width, told.height, size.width, size.height));
  }
  model.left.size_px = size;
  if (model.right) model.right->size_px = size;
}

}  // namespace

PictureRectifier::PictureRectifier(const StereoModel& given, cv::Size pictures, bool rectified)
    : size_(pictures) {
  StereoModel model = given;
  fit_to(model, pictures, remarks_);
  if (model.right)
    baseline_m_ = model.apart ? cv::norm(model.apart->translation_m) : model.baseline_m;
  const bool both_projections = model.left.rectified && (!model.right || model.right->rectified);
  if (model.pictures_rectified || rectified) {
    if (rectified && both_projections) {
      for (EyeModel* eye : {&model.left, model.right ? &*model.right : &model.left}) {
        eye->matrix = eye->rectified->projection.get_minor<3, 3>(0, 0);
      }
    }
    take_as_rectified(model);
  } else if (both_projections) {
    follow_file(model);
  } else {
    make_own(model);
  }
}

void PictureRectifier::take_as_rectified(const StereoModel& model) {
  focal_px_ = model.left.matrix(0, 0);
  centre_u_px_ = model.left.matrix(0, 2);
  centre_v_px_ = model.left.matrix(1, 2);
  if (model.right) doffs_px_ = model.right->matrix(0, 2) - model.left.matrix(0, 2);
}

void PictureRectifier::follow_file(const StereoModel& model) {
  const RectifiedEye& left = *model.left.rectified;
  make_maps(model.left, left.turn, left.projection, eyes_[0]);
  left_turn_ = left.turn;
  focal_px_ = left.projection(0, 0);
  centre_u_px_ = left.projection(0, 2);
  centre_v_px_ = left.projection(1, 2);
  if (!model.right) return;
  const RectifiedEye& right = *model.right->rectified;
  make_maps(*model.right, right.turn, right.projection, eyes_[1]);
  doffs_px_ = right.projection(0, 2) - left.projection(0, 2);
  baseline_m_ = std::abs(model.baseline_m);
}

void PictureRectifier::make_own(const StereoModel& model) {
  std::vector<TurnedEye> eyes = {{&model.left, cv::Matx33d::eye()}};
  if (model.right) {
    const auto [left, right] = side_by_side(*model.apart);
    eyes = {{&model.left, left}, {&*model.right, right}};
  }
  cv::Point2d middle(0.0, 0.0);
  for (const TurnedEye& one : eyes) {
    const cv::Point2d ray = ray_of(*one.eye, {0.5 * (size_.width - 1), 0.5 * (size_.height - 1)});
    const cv::Vec3d turned = one.turn * cv::Vec3d(ray.x, ray.y, 1.0);
    middle += cv::Point2d(turned[0] / turned[2], turned[1] / turned[2]) /
              static_cast<double>(eyes.size());
  }
  focal_px_ = widest_focal_px(eyes, middle, size_);
  const cv::Matx33d pinhole = pinhole_of(focal_px_, middle, size_);
  centre_u_px_ = pinhole(0, 2);
  centre_v_px_ = pinhole(1, 2);
  cv::Matx34d projection{};
  for (int k = 0; k < 9; ++k) projection(k / 3, k % 3) = pinhole(k / 3, k % 3);
  left_turn_ = eyes.front().turn;
  for (std::size_t k = 0; k < eyes.size(); ++k) {
    make_maps(*eyes[k].eye, eyes[k].turn, projection, eyes_[k]);
  }
}

void PictureRectifier::make_maps(const EyeModel& eye, const cv::Matx33d& turn,
                                 const cv::Matx34d& projection, Eye& to) const {
  const cv::Matx33d pinhole = projection.get_minor<3, 3>(0, 0);
  if (eye.lens == Lens::equidistant) {
    cv::fisheye::initUndistortRectifyMap(eye.matrix, eye.distortion, turn, pinhole, size_, CV_16SC2,
                                         to.map_1, to.map_2);
  } else if (eye.distortion.empty()) {
    cv::initUndistortRectifyMap(eye.matrix, cv::noArray(), turn, pinhole, size_, CV_16SC2, to.map_1,
                                to.map_2);
  } else {
    cv::initUndistortRectifyMap(eye.matrix, eye.distortion, turn, pinhole, size_, CV_16SC2,
                                to.map_1, to.map_2);
  }
}

void PictureRectifier::rectify(const cv::Mat3b& left, const cv::Mat3b& right,
                               StereoFrame& frame) const {
  const auto make = [this](const cv::Mat3b& raw, const Eye& eye, cv::Mat3b& result) {
    if (raw.empty() || eye.map_1.empty()) {
      result = raw;
      return;
    }
    if (raw.size() != size_) {
      throw UserError(fmt::format("a picture is {} x {} px, the first one was {} x {}", raw.cols,
                                  raw.rows, size_.width, size_.height));
    }
    cv::Mat3b made;
    cv::remap(raw, made, eye.map_1, eye.map_2, cv::INTER_LINEAR);
    result = made;
  };
  make(left, eyes_[0], frame.left);
  make(right, eyes_[1], frame.right);
  frame.focal_px = focal_px_;
  frame.centre_u_px = centre_u_px_;
  frame.centre_v_px = centre_v_px_;
  frame.baseline_m = right.empty() ? 0.0 : baseline_m_;
}

}  // namespace striate::datasets
