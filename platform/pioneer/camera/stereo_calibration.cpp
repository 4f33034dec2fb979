#include "striate/platform/pioneer/camera/stereo_calibration.hpp"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <opencv2/core.hpp>
#include <stdexcept>

#include "striate/base/user_error.hpp"

namespace striate::pioneer {
namespace {

CameraModel scaled(CameraModel camera, double by) {
  camera.matrix(0, 0) *= by;
  camera.matrix(1, 1) *= by;
  // Pixel centres are at integers.
  camera.matrix(0, 2) = (camera.matrix(0, 2) + 0.5) * by - 0.5;
  camera.matrix(1, 2) = (camera.matrix(1, 2) + 0.5) * by - 0.5;
  return camera;
}

template <int rows, int cols>
bool read_key(const cv::FileStorage& file, const char* key, cv::Matx<double, rows, cols>& value) {
  cv::Mat read;
  file[key] >> read;
  if (read.rows * read.cols != rows * cols || read.type() != CV_64F) return false;
  if (!cv::checkRange(read)) return false;
  value = cv::Matx<double, rows, cols>(reinterpret_cast<const double*>(read.data));
  return true;
}

bool read_from(const cv::FileStorage& file, StereoCalibration& calibration) {
  file["image_width"] >> calibration.size_px.width;
  file["image_height"] >> calibration.size_px.height;
  file["pairs"] >> calibration.pairs;
  file["reprojection_error_px"] >> calibration.reprojection_px;
  file["epipolar_error_px"] >> calibration.epipolar_px;
  return read_key(file, "left_camera_matrix", calibration.left.matrix) &&
         read_key(file, "left_distortion", calibration.left.distortion) &&
         read_key(file, "right_camera_matrix", calibration.right.matrix) &&
         read_key(file, "right_distortion", calibration.right.distortion) &&
         read_key(file, "rotation", calibration.rotation) &&
         read_key(file, "translation_m", calibration.translation_m);
}

bool makes_sense(const StereoCalibration& calibration) {
  return calibration.size_px.width > 0 && calibration.size_px.height > 0 &&
         calibration.left.matrix(0, 0) > 0.0 && calibration.right.matrix(0, 0) > 0.0 &&
         std::abs(cv::determinant(calibration.rotation) - 1.0) < 1e-3 &&
         cv::norm(calibration.translation_m) > 1e-3;
}

}  // namespace

double error_px(const StereoCalibration& calibration) {
  // Also where one is no number.
  return calibration.epipolar_px <= calibration.reprojection_px ? calibration.reprojection_px
                                                                : calibration.epipolar_px;
}

Exactness exactness_of(double error_px) {
  if (!(error_px >= 0.0 && error_px <= kUseless_px)) return Exactness::useless;
  return error_px > kPoor_px ? Exactness::poor : Exactness::good;
}

Exactness exactness_of(const StereoCalibration& calibration) {
  const double error = error_px(calibration);
  return error == 0.0 ? Exactness::unknown : exactness_of(error);
}

StereoCalibration scaled(const StereoCalibration& calibration, int width_px) {
  StereoCalibration result = calibration;
  const double by = static_cast<double>(width_px) / calibration.size_px.width;
  result.size_px = {width_px, static_cast<int>(std::lround(calibration.size_px.height * by))};
  result.left = scaled(calibration.left, by);
  result.right = scaled(calibration.right, by);
  return result;
}

StereoCalibration read_calibration(const std::string& file) {
  StereoCalibration calibration;
  bool good = false;
  try {
    // OpenCV would tell of a missing file on standard error.
    if (std::filesystem::is_regular_file(file)) {
      const cv::FileStorage storage(file, cv::FileStorage::READ);
      good = storage.isOpened() && read_from(storage, calibration) && makes_sense(calibration);
    }
  } catch (const cv::Exception&) {
    good = false;
  }
  if (!good) {
    throw UserError(file +
                    ": is no calibration of a stereo camera\n"
                    "  hint: 'striate calibrate' makes one from chessboard pairs");
  }
  return calibration;
}

StereoCalibration usable_calibration(const std::string& file) {
  const StereoCalibration calibration = read_calibration(file);
  if (exactness_of(calibration) != Exactness::useless) return calibration;
  throw UserError(
      fmt::format("{}: this calibration errs by {:.1f} px, with which no picture is matched "
                  "rightly; up to {:.0f} px can be used\n"
                  "  hint: make it anew: 'striate calibrate' names the pairs that are wrong",
                  file, error_px(calibration), kUseless_px));
}

void write_calibration(const std::string& file, const StereoCalibration& calibration) {
  cv::FileStorage storage;
  try {
    storage.open(file, cv::FileStorage::WRITE | cv::FileStorage::FORMAT_YAML);
  } catch (const cv::Exception&) {
    storage.release();
  }
  if (!storage.isOpened()) throw std::runtime_error(file + ": cannot be written");
  storage << "image_width" << calibration.size_px.width;
  storage << "image_height" << calibration.size_px.height;
  storage << "left_camera_matrix" << cv::Mat(calibration.left.matrix);
  storage << "left_distortion" << cv::Mat(calibration.left.distortion);
  storage << "right_camera_matrix" << cv::Mat(calibration.right.matrix);
  storage << "right_distortion" << cv::Mat(calibration.right.distortion);
  storage << "rotation" << cv::Mat(calibration.rotation);
  storage << "translation_m" << cv::Mat(calibration.translation_m);
  storage << "pairs" << calibration.pairs;
  storage << "reprojection_error_px" << calibration.reprojection_px;
  storage << "epipolar_error_px" << calibration.epipolar_px;
}

}  // namespace striate::pioneer
