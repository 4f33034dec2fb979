#include "striate/platform/datasets/calibration/judge_model.hpp"

#include <fmt/format.h>

#include <cmath>
#include <opencv2/core.hpp>
#include <utility>

#include "striate/base/geometry.hpp"
#include "striate/base/user_error.hpp"

namespace striate::datasets {
namespace {

/// Metres: a longer baseline is told in mm. The longest that drives is KITTI's, 0.54 m; the
/// shortest pair of lenses, told in mm, stands 20 apart. (ours)
constexpr double kLongestBaseline_m = 5.0;
/// Metres: phones have 0.01; below it nothing is told apart at arm's length (ours)
constexpr double kShortestBaseline_m = 0.002;
/// Of a rotation's nine numbers: files of three digits err by so much (ours)
constexpr double kRoughRotation = 2e-3;
constexpr double kNoRotation = 2e-2;  ///< of its numbers: beyond it, it is none (ours)

[[noreturn]] void refuse_model(const std::string& names, const std::string& what,
                               const std::string& hint) {
  throw UserError(fmt::format("{}: {}\n    hint: {}", names, what, hint));
}

void judge_eye(const EyeModel& eye, const char* which, const std::string& names) {
  const cv::Matx33d& k = eye.matrix;
  const bool finite = cv::checkRange(cv::Mat(k), true, nullptr, -1e9, 1e9);
  if (!finite || k(0, 0) <= 0.0 || k(1, 1) <= 0.0) {
    refuse_model(
        names,
        fmt::format("the {} eye's focal length is {:.6g} x {:.6g} px", which, k(0, 0), k(1, 1)),
        "fx and fy must be above 0; a driver that was not calibrated tells zeros");
  }
  if (k(0, 0) > 3.0 * k(1, 1) || k(1, 1) > 3.0 * k(0, 0) || std::abs(k(2, 2) - 1.0) > 1e-6) {
    refuse_model(names,
                 fmt::format("the {} eye's matrix is that of no camera: fx {:.6g}, fy {:.6g}",
                             which, k(0, 0), k(1, 1)),
                 "nine numbers row by row are expected: fx 0 cx, 0 fy cy, 0 0 1");
  }
  if (eye.size_px.empty()) return;
  const double u = k(0, 2) / eye.size_px.width;
  const double v = k(1, 2) / eye.size_px.height;
  if (u < -0.5 || u > 1.5 || v < -0.5 || v > 1.5) {
    refuse_model(names,
                 fmt::format("the {} eye's principal point ({:.6g}, {:.6g}) lies far outside its "
                             "{} x {} px",
                             which, k(0, 2), k(1, 2), eye.size_px.width, eye.size_px.height),
                 "is it of pictures of another size, or are width and height exchanged?");
  }
}

void judge_rotation(cv::Matx33d& r, const char* what, const std::string& names,
                    std::vector<std::string>& remarks) {
  const double error = cv::norm(r * r.t() - cv::Matx33d::eye(), cv::NORM_INF);
  if (!(error < kNoRotation) || cv::determinant(r) < 0.0) {
    refuse_model(names, fmt::format("{} is no rotation: its rows err by {:.2g}", what, error),
                 "its rows must be of length 1 and square to each other, and turn right-handed");
  }
  if (error > kRoughRotation) {
    remarks.push_back(fmt::format("{} errs by {:.2g} and was made a rotation", what, error));
  }
  cv::Matx33d u;
  cv::Matx31d w;
  cv::Matx33d vt;
  cv::SVD::compute(r, w, u, vt);
  r = u * vt;
}

/// Of a rectified pair both projections say what the eyes have in common.
void take_rectified(StereoModel& model, const std::string& names) {
  if (!model.left.rectified || !model.right || !model.right->rectified) return;
  const cv::Matx34d& a = model.left.rectified->projection;
  const cv::Matx34d& b = model.right->rectified->projection;
  if (!(a(0, 0) > 0.0) || !(b(0, 0) > 0.0)) {
    refuse_model(names, "a projection matrix has no focal length", "its first number must be > 0");
  }
  if (std::abs(a(1, 2) - b(1, 2)) > 0.5 || std::abs(a(1, 1) - b(1, 1)) > 1e-2 * a(1, 1)) {
    refuse_model(names, "the projection matrices of the two eyes are of no rectified pair",
                 "fy and cy must be the same in both: were the eyes calibrated one by one?");
  }
  if (std::abs(b(1, 3) - a(1, 3)) > std::abs(b(0, 3) - a(0, 3))) {
    refuse_model(names, "the second eye stands above or below the first one",
                 "pictures of eyes side by side are needed: turn both by 90 degrees");
  }
  model.baseline_m = a(0, 3) / a(0, 0) - b(0, 3) / b(0, 0);
  model.doffs_px = b(0, 2) - a(0, 2);
}

double signed_baseline(const StereoModel& model) {
  if (!model.apart) return model.baseline_m;
  const double length = cv::norm(model.apart->translation_m);
  return model.apart->translation_m[0] <= 0.0 ? length : -length;
}

void judge_unit(StereoModel& model, const std::string& names) {
  const double told = std::abs(signed_baseline(model));
  if (told == 0.0 && !model.apart) {
    model.remarks.emplace_back(
        "it has no baseline: no distances in metres (P of the right eye has "
        "-fx B in its fourth column)");
    return;
  }
  double baseline_m = told;
  if (told > kLongestBaseline_m) {
    baseline_m = 1e-3 * told;
    model.remarks.push_back(
        fmt::format("its baseline is {:.6g}: taken for mm, so {:.4g} m", told, baseline_m));
    if (model.apart) model.apart->translation_m *= 1e-3;
    model.baseline_m *= 1e-3;
  } else if (told > 1.0) {
    model.remarks.push_back(fmt::format(
        "its baseline is {:.4g}, taken for metres: was the board's square given in another unit?",
        told));
  }
  if (!(baseline_m > kShortestBaseline_m) || !(baseline_m < kLongestBaseline_m)) {
    refuse_model(names, fmt::format("the eyes stand {:.4g} m apart", baseline_m),
                 "the translation T must be in metres (or mm), and of two cameras");
  }
}

/// EuRoC, Kalibr, KITTI number their cameras: which of them is the left one is for us to find out.
bool numbers_its_cameras(const StereoModel& model) {
  return model.format.starts_with("EuRoC") || model.format.starts_with("Kalibr") ||
         model.format.starts_with("KITTI");
}

void judge_order(StereoModel& model, const std::string& names) {
  if (model.apart) {
    const cv::Vec3d& t = model.apart->translation_m;
    if (std::abs(t[1]) > std::abs(t[0]) || std::abs(t[2]) > std::abs(t[0])) {
      refuse_model(names,
                   fmt::format("the eyes stand ({:.4g}, {:.4g}, {:.4g}) m apart: not side by side",
                               t[0], t[1], t[2]),
                   "T of OpenCV goes along x; pictures of eyes above each other are not taken");
    }
  }
  if (signed_baseline(model) >= 0.0) return;
  if (model.format.starts_with("ROS")) {  // a file an eye, and P says which it is
    exchange_eyes(model);
    model.remarks.emplace_back("the right eye's file was given first: taken so");
    return;
  }
  if (numbers_its_cameras(model)) {
    exchange_eyes(model);
    model.eyes_exchanged = true;
    model.remarks.emplace_back("the camera that it names first stands on the right: taken so");
    return;
  }
  refuse_model(names,
               "its right camera stands left of the left one: the translation's x is above 0",
               "OpenCV's T takes a point of the left camera to the right one, so that its x is "
               "below 0. If the file tells where the right camera is, give T the other sign (and R "
               "transposed); if the eyes are exchanged, say --swap");
}

}  // namespace

void exchange_eyes(StereoModel& model) {
  if (!model.right) return;
  std::swap(model.left, *model.right);
  model.baseline_m = -model.baseline_m;
  model.doffs_px = -model.doffs_px;
  if (model.apart) {
    model.apart->rotation = model.apart->rotation.t();
    model.apart->translation_m = -(model.apart->rotation * model.apart->translation_m);
  }
  if (!model.left.rectified || !model.right->rectified) return;
  cv::Matx34d& a = model.left.rectified->projection;
  cv::Matx34d& b = model.right->rectified->projection;
  // Where the pair's own frame has its middle does not matter: the left one's is it.
  b(0, 3) = b(0, 0) * (b(0, 3) / b(0, 0) - a(0, 3) / a(0, 0));
  a(0, 3) = 0.0;
}

void judge_model(StereoModel& model, const std::string& names) {
  judge_eye(model.left, "left", names);
  if (model.left.rectified) {
    judge_rotation(model.left.rectified->turn, "the left eye's R", names, model.remarks);
  }
  if (!model.right) {
    if (model.remarks.empty()) {
      model.remarks.emplace_back("it tells one eye alone: no distances");
    }
    return;
  }
  judge_eye(*model.right, "right", names);
  if (model.right->rectified) {
    judge_rotation(model.right->rectified->turn, "the right eye's R", names, model.remarks);
  }
  if (model.left.size_px != model.right->size_px && !model.left.size_px.empty() &&
      !model.right->size_px.empty()) {
    refuse_model(names, "the two eyes' pictures are of different sizes",
                 "eyes of one kind are needed: a pair must have one size");
  }
  if (model.apart) {
    judge_rotation(model.apart->rotation, "the rotation between the eyes", names, model.remarks);
  }
  take_rectified(model, names);
  if (!model.apart && !(model.left.rectified && model.right->rectified) &&
      !model.pictures_rectified) {
    refuse_model(names, "it does not tell how the eyes stand to each other",
                 "R and T of OpenCV's stereoCalibrate, or R1, P1, R2 and P2 of stereoRectify");
  }
  if (model.pictures_rectified) {
    model.doffs_px = model.right->matrix(0, 2) - model.left.matrix(0, 2);
  }
  judge_order(model, names);
  judge_unit(model, names);
}

}  // namespace striate::datasets
