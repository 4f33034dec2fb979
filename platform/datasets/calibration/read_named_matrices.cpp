
#include <cmath>
#include <opencv2/calib3d.hpp>

#include "striate/platform/datasets/calibration/calibration_formats.hpp"
#include "striate/platform/datasets/calibration/eye_fields.hpp"
#include "striate/platform/datasets/calibration/named_parts.hpp"
#include "striate/platform/datasets/calibration/text_tree.hpp"

namespace striate::datasets {
namespace {

using config::Node;

const Node& unwrapped(const Node& root) {
  const Node::Entry* storage = root.find("opencv_storage");
  return storage != nullptr && storage->value.kind == Node::Kind::map ? storage->value : root;
}

std::optional<cv::Matx33d> matrix_in(const NamedParts& parts, Eye eye,
                                     config::Diagnostics& diagnostics) {
  const Node* node = parts.find(Part::matrix, eye);
  if (node != nullptr && node->find("fx") != nullptr) {  // {fx: ..., cx: ...} in any order
    return matrix_in(NamedParts(*node), Eye::both, diagnostics);
  }
  if (node != nullptr) {
    const std::size_t before = diagnostics.count();
    if (numbers_of(*node, parts.key(Part::matrix, eye), diagnostics).size() == 4 &&
        diagnostics.count() == before) {
      return matrix_of_four(*node, diagnostics);
    }
    if (diagnostics.count() != before) return {};
    return matrix_of<3, 3>(*node, parts.key(Part::matrix, eye), diagnostics);
  }
  double four[4] = {};
  constexpr Part kFour[4] = {Part::fx, Part::fy, Part::cx, Part::cy};
  constexpr const char* kFourNames[4] = {"fx", "fy", "cx", "cy"};
  for (int k = 0; k < 4; ++k) {
    const Node* one = parts.own_or_common(kFour[k], eye);
    const auto value = number_in(one, kFourNames[k], diagnostics);
    if (!value) return {};
    four[k] = *value;
  }
  return camera_matrix(four[0], four[1], four[2], four[3]);
}

cv::Size size_in(const NamedParts& parts, Eye eye, config::Diagnostics& diagnostics) {
  const cv::Size told = size_of(parts.own_or_common(Part::width, eye),
                                parts.own_or_common(Part::height, eye), diagnostics);
  if (!told.empty()) return told;
  const Node* both = parts.own_or_common(Part::size, eye);
  if (both == nullptr) return {};
  const std::vector<double> numbers = numbers_of(*both, "the size of the pictures", diagnostics);
  if (numbers.size() != 2 || numbers[0] < 1.0 || numbers[1] < 1.0 || numbers[0] > 65536.0 ||
      numbers[1] > 65536.0) {
    return {};
  }
  return {static_cast<int>(numbers[0]), static_cast<int>(numbers[1])};
}

/// @return whether the eye has a matrix of its own
bool read_eye(const NamedParts& parts, Eye which, EyeModel& eye, StereoModel& model,
              config::Diagnostics& diagnostics) {
  eye.size_px = size_in(parts, which, diagnostics);
  const auto matrix = matrix_in(parts, which, diagnostics);
  if (matrix) eye.matrix = *matrix;
  const Node* lens_model = parts.own_or_common(Part::lens_model, which);
  const Node* lens = parts.find(Part::lens, which);
  set_distortion(lens, lens_model, eye, diagnostics);
  if (lens_model == nullptr && eye.distortion.size() == 4) {
    model.remarks.emplace_back(
        "the lens has 4 coefficients, taken for k1 k2 p1 p2; of a fisheye say in the file "
        "distortion_model: equidistant");
  }
  if (const Node* projection = parts.find(Part::projection, which)) {
    const auto p = matrix_of<3, 4>(*projection, parts.key(Part::projection, which), diagnostics);
    RectifiedEye rectified;
    if (p) rectified.projection = *p;
    if (const Node* turn = parts.find(Part::turn, which)) {
      const auto r = matrix_of<3, 3>(*turn, parts.key(Part::turn, which), diagnostics);
      if (r) rectified.turn = *r;
    }
    if (p) eye.rectified = rectified;
  }
  return matrix.has_value();
}

/// Rodrigues' vector is what some write instead of the matrix.
std::optional<cv::Matx33d> rotation_in(const Node& node, config::Diagnostics& diagnostics) {
  const std::size_t before = diagnostics.count();
  const std::vector<double> numbers = numbers_of(node, "the rotation R", diagnostics);
  if (diagnostics.count() != before) return {};
  if (numbers.size() != 3) return matrix_of<3, 3>(node, "the rotation R", diagnostics);
  cv::Matx33d rotation;
  cv::Rodrigues(cv::Vec3d(numbers.data()), rotation);
  return rotation;
}

void read_apart(const NamedParts& parts, StereoModel& model, config::Diagnostics& diagnostics) {
  const Node* way = parts.find(Part::way, Eye::both);
  if (way == nullptr) way = parts.find(Part::way, Eye::second);
  if (way == nullptr) return;
  const auto t = matrix_of<3, 1>(*way, "the translation T", diagnostics);
  if (!t) return;
  EyesApart apart;
  apart.translation_m = {t->val[0], t->val[1], t->val[2]};
  if (const Node* turn = parts.find(Part::turn, Eye::both)) {
    const auto r = rotation_in(*turn, diagnostics);
    if (!r) return;
    apart.rotation = *r;
  } else {
    model.remarks.emplace_back("it has T without R: the eyes are taken for parallel");
  }
  model.apart = apart;
}

/// Rectified pictures of which stereoRectify's Q alone was kept.
void read_to_depth(const Node& node, StereoModel& model, config::Diagnostics& diagnostics) {
  const auto q = matrix_of<4, 4>(node, "Q", diagnostics);
  if (!q) return;
  const double focal_px = (*q)(2, 3);
  const double baseline = (*q)(3, 2) != 0.0 ? 1.0 / (*q)(3, 2) : 0.0;
  model.pictures_rectified = true;
  model.left.matrix = camera_matrix(focal_px, focal_px, -(*q)(0, 3), -(*q)(1, 3));
  model.right = model.left;
  // Q's last number is (cx - cx') / Tx, with Tx = -B.
  model.doffs_px = (*q)(3, 3) * baseline;
  model.right->matrix(0, 2) += model.doffs_px;
  model.baseline_m = std::abs(baseline);
}

}  // namespace

bool is_named_matrices(const Node& root) {
  const NamedParts parts(unwrapped(root));
  for (const Eye eye : {Eye::first, Eye::second}) {
    if (parts.find(Part::matrix, eye) != nullptr || parts.find(Part::projection, eye) != nullptr) {
      return true;
    }
  }
  return parts.find(Part::to_depth, Eye::both) != nullptr ||
         (parts.find(Part::fx, Eye::both) != nullptr &&
          parts.find(Part::cx, Eye::both) != nullptr) ||
         (parts.find(Part::matrix, Eye::both) != nullptr);
}

StereoModel read_named_matrices(const Node& given, config::Diagnostics& diagnostics) {
  const Node& root = unwrapped(given);
  const NamedParts parts(root);
  StereoModel model;
  model.format =
      root.find("left_camera_matrix") != nullptr ? "Striate calibrate" : "OpenCV (named matrices)";
  EyeModel right;
  const bool first = read_eye(parts, Eye::first, model.left, model, diagnostics);
  const bool second = read_eye(parts, Eye::second, right, model, diagnostics);
  if (!first && !second && model.left.rectified && right.rectified) {
    model.pictures_rectified = true;
    for (EyeModel* eye : {&model.left, &right}) {
      eye->matrix = eye->rectified->projection.get_minor<3, 3>(0, 0);
    }
    model.right = right;
  } else if (first && (second || right.rectified)) {
    model.right = right;
    read_apart(parts, model, diagnostics);
  } else if (const Node* q = parts.find(Part::to_depth, Eye::both); q != nullptr && !first) {
    read_to_depth(*q, model, diagnostics);
  } else if (!first) {  // one camera, or two alike
    const bool one = read_eye(parts, Eye::both, model.left, model, diagnostics);
    if (one && parts.find(Part::baseline, Eye::both) != nullptr) {
      model.right = model.left;
      model.pictures_rectified = true;
    }
  }
  const auto baseline = number_in(parts.find(Part::baseline, Eye::both), "baseline", diagnostics);
  if (baseline && model.pictures_rectified && model.baseline_m == 0.0) model.baseline_m = *baseline;
  return model;
}

}  // namespace striate::datasets
