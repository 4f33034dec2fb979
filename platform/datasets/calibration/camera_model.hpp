#pragma once

#include <opencv2/core/matx.hpp>
#include <opencv2/core/types.hpp>
#include <optional>
#include <string>
#include <vector>

/// What is known of a camera that somebody else has calibrated. Pixel centres at integers.
namespace striate::datasets {

/// How a lens bends what a pinhole would show.
enum class Lens {
  straight,           ///< not at all
  radial_tangential,  ///< Brown's: k1 k2 p1 p2 [k3 [k4 k5 k6 [s1 s2 s3 s4 [tx ty]]]], as OpenCV
  equidistant         ///< Kannala and Brandt's, OpenCV's fisheye: k1 k2 k3 k4
};

/// What makes rectified pictures of raw ones: OpenCV's R1 and P1, ROS's rectification_matrix and
/// projection_matrix.
struct RectifiedEye {
  cv::Matx33d turn = cv::Matx33d::eye();
  cv::Matx34d projection{};  ///< its fourth column: -f B in px m, or 0
};

struct EyeModel {
  cv::Size size_px;  ///< of the pictures; empty: the file does not tell
  cv::Matx33d matrix = cv::Matx33d::eye();
  Lens lens = Lens::straight;
  std::vector<double> distortion;  ///< in the lens's order; empty where it is straight
  std::optional<RectifiedEye> rectified;
};

/// A point X of the left camera is R X + t in the right one.
struct EyesApart {
  cv::Matx33d rotation = cv::Matx33d::eye();
  cv::Vec3d translation_m{};
};

struct StereoModel {
  std::string format;  ///< "EuRoC sensor.yaml"
  EyeModel left;
  std::optional<EyeModel> right;   ///< nothing: the file knows of one camera
  std::optional<EyesApart> apart;  ///< nothing: not told (rectified pictures need it not)
  double baseline_m = 0.0;         ///< of a rectified pair; 0: not told
  double doffs_px = 0.0;  ///< of a rectified pair: the right principal point's column less the left
  bool pictures_rectified = false;   ///< the file is of pictures that are rectified already
  bool eyes_exchanged = false;       ///< the camera that the file names first is the right eye
  std::vector<std::string> remarks;  ///< what was assumed, and what is missing, in plain words
};

}  // namespace striate::datasets
