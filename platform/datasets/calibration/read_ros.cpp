#include "striate/platform/datasets/calibration/calibration_formats.hpp"
#include "striate/platform/datasets/calibration/eye_fields.hpp"
#include "striate/platform/datasets/calibration/text_tree.hpp"

namespace striate::datasets {

namespace {

const std::vector<std::string> kInfoMatrix = {"camera_matrix", "K", "k"};
const std::vector<std::string> kInfoProjection = {"projection_matrix", "P", "p"};
const std::vector<std::string> kInfoTurn = {"rectification_matrix", "R", "r"};
const std::vector<std::string> kInfoLens = {"distortion_coefficients", "D", "d"};

}  // namespace

/// `camera_matrix` alone is OpenCV's file of one camera, whose eye can be read in the same way.
bool is_camera_info(const config::Node& root) {
  return first_of(root, kInfoMatrix) != nullptr &&
         (first_of(root, kInfoProjection) != nullptr || first_of(root, kInfoLens) != nullptr) &&
         root.find("T") == nullptr && root.find("K1") == nullptr;
}

OneEye read_camera_info(const config::Node& root, config::Diagnostics& diagnostics) {
  OneEye one;
  one.format =
      first_of(root, kInfoProjection) != nullptr ? "ROS camera_info" : "OpenCV, one camera";
  const auto matrix =
      matrix_of<3, 3>(*first_of(root, kInfoMatrix), "the camera's matrix", diagnostics);
  if (matrix) one.eye.matrix = *matrix;
  one.eye.size_px = size_of(first_of(root, {"image_width", "width"}),
                            first_of(root, {"image_height", "height"}), diagnostics);
  set_distortion(first_of(root, kInfoLens), first_of(root, {"distortion_model", "camera_model"}),
                 one.eye, diagnostics);
  const config::Node* projection = first_of(root, kInfoProjection);
  if (projection == nullptr) return one;
  const auto p = matrix_of<3, 4>(*projection, "the projection matrix P", diagnostics);
  RectifiedEye rectified;
  if (p) rectified.projection = *p;
  if (const config::Node* turn = first_of(root, kInfoTurn)) {
    const auto r = matrix_of<3, 3>(*turn, "the rectification matrix R", diagnostics);
    if (r) rectified.turn = *r;
  }
  // A driver that is not calibrated sends zeros.
  if (p && rectified.projection(0, 0) > 0.0) one.eye.rectified = rectified;
  return one;
}

}  // namespace striate::datasets
