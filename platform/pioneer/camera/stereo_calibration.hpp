#pragma once

#include <opencv2/core/mat.hpp>
#include <opencv2/core/matx.hpp>
#include <string>

namespace striate::pioneer {

/// One camera of a pair: the pinhole's matrix and the lens's distortion (k1 k2 p1 p2 k3).
struct CameraModel {
  cv::Matx33d matrix = cv::Matx33d::eye();
  cv::Vec<double, 5> distortion{};
};

/// What is known of a stereo camera. A point X of the left camera is R X + t in the right one.
struct StereoCalibration {
  cv::Size size_px;  ///< of the images that it was made from, and that it holds for
  CameraModel left;
  CameraModel right;
  cv::Matx33d rotation = cv::Matx33d::eye();
  cv::Vec3d translation_m{};
  int pairs = 0;                 ///< of images that went into it
  double reprojection_px = 0.0;  ///< root mean square, from where the corners should be
  double epipolar_px = 0.0;  ///< root mean square of the height between matching corners, rectified
};

/// How far a calibration may be trusted, by the errors that were measured when it was made.
enum class Exactness {
  good,
  poor,     ///< above kPoor_px: distances suffer
  useless,  ///< above kUseless_px, or no number: no picture is matched rightly with it
  unknown   ///< it tells no error
};

/// Px. Corners are found within a tenth of one: what errs by a whole one was looked at wrongly.
inline constexpr double kPoor_px = 1.0;
/// Px. The paper's camera has 24 px of disparity at 4 m in images 640 px wide (f B = 97 px m): 3 px
/// are an eighth of the distance there, and rows that differ by as many share no texture.
inline constexpr double kUseless_px = 3.0;

/// The worse one of both errors.
[[nodiscard]] double error_px(const StereoCalibration& calibration);
[[nodiscard]] Exactness exactness_of(double error_px);
[[nodiscard]] Exactness exactness_of(const StereoCalibration& calibration);

/// The same cameras with images of another width; the shape stays.
[[nodiscard]] StereoCalibration scaled(const StereoCalibration& calibration, int width_px);

/// YAML as OpenCV's FileStorage writes it.
/// @throws UserError when the file cannot be read or does not hold a calibration.
[[nodiscard]] StereoCalibration read_calibration(const std::string& file);

/// The same, for a robot that is to drive by it. @throws UserError, too, where it is useless.
[[nodiscard]] StereoCalibration usable_calibration(const std::string& file);
/// @throws std::runtime_error when it cannot be written.
void write_calibration(const std::string& file, const StereoCalibration& calibration);

}  // namespace striate::pioneer
