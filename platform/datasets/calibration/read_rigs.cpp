#include <fmt/format.h>

#include "striate/base/plain_text.hpp"
#include "striate/platform/datasets/calibration/calibration_formats.hpp"
#include "striate/platform/datasets/calibration/eye_fields.hpp"
#include "striate/platform/datasets/calibration/text_tree.hpp"

namespace striate::datasets {
namespace {

using config::Node;

/// EuRoC and Kalibr name the same things, in different words.
EyeModel read_pinhole(const Node& root, config::Diagnostics& diagnostics) {
  EyeModel eye;
  const Node* model = first_of(root, {"camera_model"});
  if (model != nullptr && model->text != "pinhole") {
    diagnostics.add(config::fault::unknown_choice, model->place,
                    fmt::format("the camera model '{}' is not known", plain_text(model->text)),
                    "pinhole is: calibrate with 'pinhole-radtan' or 'pinhole-equi'");
  }
  if (const Node* four = first_of(root, {"intrinsics"})) {
    const auto matrix = matrix_of_four(*four, diagnostics);
    if (matrix) eye.matrix = *matrix;
  } else {
    diagnostics.add(config::fault::missing_key, root.place, "'intrinsics' is missing",
                    "[fu, fv, cu, cv] in px");
  }
  set_distortion(first_of(root, {"distortion_coeffs", "distortion_coefficients"}),
                 first_of(root, {"distortion_model"}), eye, diagnostics);
  if (const Node* size = first_of(root, {"resolution"})) {
    if (size->items.size() == 2) {
      eye.size_px = size_of(&size->items[0], &size->items[1], diagnostics);
    } else {
      diagnostics.add(config::fault::wrong_kind, size->place,
                      "'resolution' must be [width, height]");
    }
  }
  return eye;
}

/// From the first camera to the second, in any of the three ways that a rig is told.
std::optional<cv::Matx44d> second_from_first(const Node& first, const Node& second,
                                             config::Diagnostics& diagnostics) {
  if (const Node* chain = first_of(second, {"T_cn_cnm1"})) {
    return motion_of(*chain, "T_cn_cnm1", diagnostics);
  }
  for (const char* key : {"T_imu_cam", "T_BS", "T_cam_imu"}) {
    const Node* of_first = first_of(first, {key});
    const Node* of_second = first_of(second, {key});
    if (of_first == nullptr || of_second == nullptr) continue;
    const auto a = motion_of(*of_first, key, diagnostics);
    const auto b = motion_of(*of_second, key, diagnostics);
    if (!a || !b) return {};
    const bool to_camera = std::string(key) == "T_cam_imu";
    return to_camera ? *b * inverse_motion(*a) : inverse_motion(*b) * *a;
  }
  return {};
}

}  // namespace

bool is_euroc_sensor(const Node& root) {
  return root.find("intrinsics") != nullptr &&
         (root.find("T_BS") != nullptr || root.find("sensor_type") != nullptr);
}

OneEye read_euroc_sensor(const Node& root, config::Diagnostics& diagnostics) {
  OneEye one{"EuRoC sensor.yaml", read_pinhole(root, diagnostics), {}};
  if (const Node* place = first_of(root, {"T_BS"})) {
    one.body_from_eye = motion_of(*place, "T_BS", diagnostics);
  }
  return one;
}

bool is_kalibr(const Node& root) {
  const Node::Entry* first = root.find("cam0");
  return first != nullptr && first->value.kind == Node::Kind::map &&
         first->value.find("intrinsics") != nullptr;
}

StereoModel read_kalibr(const Node& root, config::Diagnostics& diagnostics) {
  StereoModel model;
  model.format = "Kalibr camchain";
  const Node& first = root.find("cam0")->value;
  model.left = read_pinhole(first, diagnostics);
  const Node::Entry* second = root.find("cam1");
  if (second == nullptr || second->value.kind != Node::Kind::map) {
    model.remarks.emplace_back("it has cam0 alone: no second eye, and no distances");
    return model;
  }
  model.right = read_pinhole(second->value, diagnostics);
  const auto motion = second_from_first(first, second->value, diagnostics);
  if (motion) model.apart = apart_of(*motion);
  if (!motion && diagnostics.none()) {
    diagnostics.add(config::fault::missing_key, second->key_place,
                    "cam1 does not say where it is: 'T_cn_cnm1' is missing",
                    "calibrate both cameras in one run of Kalibr");
  }
  if (root.find("cam2") != nullptr) {
    model.remarks.emplace_back("it has more than two cameras: cam0 and cam1 are taken");
  }
  return model;
}

namespace {

EyeModel read_boofcv_eye(const Node* of_file, config::Diagnostics& diagnostics) {
  EyeModel eye;
  if (of_file == nullptr) {
    diagnostics.add(config::fault::missing_key, {}, "'left' or 'right' is missing");
    return eye;
  }
  double four[4] = {};
  const char* keys[4] = {"fx", "fy", "cx", "cy"};
  for (int k = 0; k < 4; ++k) {
    const Node* node = first_of(*of_file, {keys[k]});
    const auto value = node != nullptr ? number_of(node->text) : std::nullopt;
    if (!value) {
      diagnostics.add(config::fault::missing_key, node != nullptr ? node->place : of_file->place,
                      fmt::format("'{}' is missing, or no number", keys[k]));
      return eye;
    }
    four[k] = *value;
  }
  eye.matrix = camera_matrix(four[0], four[1], four[2], four[3]);
  eye.size_px = size_of(first_of(*of_file, {"width"}), first_of(*of_file, {"height"}), diagnostics);
  std::vector<double> radial;
  if (const Node* node = first_of(*of_file, {"radial"})) {
    radial = numbers_of(*node, "radial", diagnostics);
  }
  const auto tangential = [&](const char* key) {
    const Node* node = first_of(*of_file, {key});
    return number_in(node, key, diagnostics).value_or(0.0);
  };
  radial.resize(std::max<std::size_t>(2, radial.size()), 0.0);
  eye.distortion = {radial[0], radial[1], tangential("t1"), tangential("t2")};
  if (radial.size() > 2) eye.distortion.push_back(radial[2]);
  eye.lens = Lens::radial_tangential;
  return eye;
}

constexpr const char* kBoofRoot = "boofcv.struct.calib.StereoParameters";

}  // namespace

bool is_boofcv(const Node& root) {
  return root.find(kBoofRoot) != nullptr;
}

StereoModel read_boofcv(const Node& root, config::Diagnostics& diagnostics) {
  StereoModel model;
  model.format = "BoofCV";
  const Node& all = root.find(kBoofRoot)->value;
  model.left = read_boofcv_eye(first_of(all, {"left"}), diagnostics);
  model.right = read_boofcv_eye(first_of(all, {"right"}), diagnostics);
  const Node* motion = first_of(all, {"rightToLeft"});
  const Node* turn = motion != nullptr ? first_of(*motion, {"R", "r"}) : nullptr;
  const Node* way = motion != nullptr ? first_of(*motion, {"T", "t"}) : nullptr;
  if (turn == nullptr || way == nullptr) {
    diagnostics.add(config::fault::missing_key, {}, "'rightToLeft' with R and T is missing");
    return model;
  }
  const Node* numbers = first_of(*turn, {"data"});
  const auto r = matrix_of<3, 3>(numbers != nullptr ? *numbers : *turn, "R", diagnostics);
  const auto t = matrix_of<3, 1>(*way, "T", diagnostics);
  if (!r || !t) return model;
  // It takes points of the right eye to the left one; ours goes the other way.
  const cv::Matx33d back = r->t();
  const cv::Vec3d to_right = back * cv::Vec3d(t->val[0], t->val[1], t->val[2]);
  model.apart = EyesApart{back, -to_right};
  return model;
}

}  // namespace striate::datasets
